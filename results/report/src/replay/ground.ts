// The ground: a grid of whole and half metres that fades into the distance, the shadows on it, and blocks.
import {
  BoxGeometry, CanvasTexture, Color, EdgesGeometry, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial,
  MeshStandardMaterial, PlaneGeometry, RepeatWrapping, ShadowMaterial,
} from "three";
import type { Box } from "../data";

const kHalf = 40; // [m]

export class Ground {
  readonly object = new Group();
  private readonly plane = new PlaneGeometry(2 * kHalf, 2 * kHalf);
  private readonly shadow = new ShadowMaterial();
  // A texture, as lines of one pixel flicker in the distance.
  private readonly grid = new MeshBasicMaterial({ map: tile(), transparent: true, depthWrite: false });

  constructor() {
    const grid = new Mesh(this.plane, this.grid);
    const shadow = new Mesh(this.plane, this.shadow);
    grid.renderOrder = -2;
    shadow.renderOrder = -1;
    shadow.position.z = 0.0005;
    shadow.receiveShadow = true;
    this.object.add(grid, shadow);
  }

  paint(dark: boolean): void {
    this.shadow.opacity = dark ? 0.55 : 0.2;
    this.grid.color = new Color(dark ? 0x5d6a79 : 0xa3afbb);
  }

  dispose(): void {
    this.plane.dispose();
    this.shadow.dispose();
    this.grid.map?.dispose();
    this.grid.dispose();
  }
}

// One square metre: its border strong, its halves faint.
function tile(): CanvasTexture {
  const size = 1024;
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = size;
  const pen = canvas.getContext("2d");
  if (pen) {
    pen.fillStyle = "rgb(255 255 255 / 50%)";
    pen.fillRect(size / 2 - 1, 0, 3, size);
    pen.fillRect(0, size / 2 - 1, size, 3);
    pen.fillStyle = "#fff";
    for (const [x, y, w, h] of [[0, 0, 2, size], [size - 2, 0, 2, size], [0, 0, size, 2], [0, size - 2, size, 2]] as const) {
      pen.fillRect(x, y, w, h);
    }
  }
  const texture = new CanvasTexture(canvas);
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.repeat.set(2 * kHalf, 2 * kHalf);
  texture.anisotropy = 8;
  return texture;
}

/** The blocks of a scenario; lower friction is darker. */
export class Blocks {
  readonly object = new Group();
  private readonly meshes: Mesh<BoxGeometry, MeshStandardMaterial>[] = [];
  private readonly edges: LineSegments<EdgesGeometry, LineBasicMaterial>[] = [];

  constructor(private readonly boxes: Box[]) {
    for (const box of boxes) {
      const mesh = new Mesh(new BoxGeometry(...box.size), new MeshStandardMaterial({ roughness: 0.9 }));
      mesh.position.fromArray(box.center);
      mesh.rotation.z = box.yaw;
      mesh.receiveShadow = true;
      mesh.castShadow = true;
      const edge = new LineSegments(new EdgesGeometry(mesh.geometry), new LineBasicMaterial());
      mesh.add(edge);
      this.meshes.push(mesh);
      this.edges.push(edge);
      this.object.add(mesh);
    }
  }

  paint(dark: boolean): void {
    this.meshes.forEach((mesh, i) => {
      const friction = Math.min(Math.max(this.boxes[i]?.friction ?? 0.6, 0), 1);
      mesh.material.color.set(dark ? 0x4a4238 : 0xd8c8ae).multiplyScalar(0.65 + 0.5 * friction);
      this.edges[i]?.material.color.set(dark ? 0x7d705f : 0x8f7d60);
    });
  }

  dispose(): void {
    for (const mesh of this.meshes) {
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
    for (const edge of this.edges) {
      edge.geometry.dispose();
      edge.material.dispose();
    }
  }
}
