// The directions in a corner of each view: x of travel, y to the left, z up.
import {
  ArrowHelper, CanvasTexture, Group, OrthographicCamera, type PerspectiveCamera, Scene, Sprite, SpriteMaterial, SRGBColorSpace, Vector3,
  type WebGLRenderer,
} from "three";

const kAxes = [
  { name: "x", direction: new Vector3(1, 0, 0), color: "#d1495b" },
  { name: "y", direction: new Vector3(0, 1, 0), color: "#3f9142" },
  { name: "z", direction: new Vector3(0, 0, 1), color: "#3b7dd8" },
];
const kSize = 84; // [px]

export class AxesGizmo {
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera(-1.45, 1.45, 1.45, -1.45, 0, 10);
  private readonly arrows = new Group();
  private readonly letters: SpriteMaterial[] = [];

  constructor() {
    for (const axis of kAxes) {
      this.arrows.add(new ArrowHelper(axis.direction, new Vector3(), 0.95, axis.color, 0.3, 0.18));
      const material = new SpriteMaterial({ map: letter(axis.name, axis.color), depthTest: false });
      const sprite = new Sprite(material);
      sprite.position.copy(axis.direction).multiplyScalar(1.2);
      sprite.scale.setScalar(0.5);
      this.letters.push(material);
      this.arrows.add(sprite);
    }
    this.scene.add(this.arrows);
  }

  /** Into the lower left corner of the view whose corner is x, y [px from the bottom left]. */
  draw(renderer: WebGLRenderer, camera: PerspectiveCamera, x: number, y: number): void {
    this.camera.quaternion.copy(camera.quaternion);
    this.camera.position.set(0, 0, 5).applyQuaternion(camera.quaternion);
    renderer.setViewport(x + 6, y + 6, kSize, kSize);
    renderer.setScissor(x + 6, y + 6, kSize, kSize);
    renderer.clearDepth();
    renderer.render(this.scene, this.camera);
  }

  dispose(): void {
    for (const material of this.letters) {
      material.map?.dispose();
      material.dispose();
    }
    for (const child of this.arrows.children) if (child instanceof ArrowHelper) child.dispose();
  }
}

function letter(text: string, color: string): CanvasTexture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const pen = canvas.getContext("2d");
  if (pen) {
    pen.font = "bold 52px sans-serif";
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    pen.fillStyle = color;
    pen.fillText(text, 32, 32);
  }
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  return texture;
}
