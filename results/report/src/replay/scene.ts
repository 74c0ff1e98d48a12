// Canvas, lights, ground and theme; draws one or two views with the same camera.
import {
  Color, DirectionalLight, Fog, HemisphereLight, MathUtils, type Object3D, PCFShadowMap, type PerspectiveCamera, Scene, type Vector3,
  WebGLRenderer,
} from "three";
import type { AxesGizmo } from "./axes_gizmo";
import { Ground } from "./ground";

/** One robot with what belongs to it, or two of them. */
export interface View {
  objects: Object3D[];
  target: Vector3; // what the light falls on
  shift: Vector3; // of the camera
}

type Area = [x: number, y: number, width: number, height: number]; // [px] from the lower left corner

const kAngle = 32; // [deg] of the camera, from top to bottom
const kLeastAspect = 1.05; // narrower views get a wider angle, so that the robot is not cut off

export class NoWebGl extends Error {}

export class Stage {
  readonly scene = new Scene();
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly ground = new Ground();
  private readonly sky = new HemisphereLight(0xffffff, 0xb9b2a6, 1.9);
  private readonly sun = new DirectionalLight(0xffffff, 2.1);

  /** Throws NoWebGl if the browser has none. */
  constructor() {
    this.canvas = document.createElement("canvas");
    // Asked for here, as three.js would log an error where there is none.
    const context = this.canvas.getContext("webgl2", { antialias: true, alpha: false, powerPreference: "low-power" });
    if (!context) throw new NoWebGl("This browser draws no 3D graphics (WebGL 2 is missing or switched off).");
    this.renderer = new WebGLRenderer({ canvas: this.canvas, context });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.autoClear = false;
    this.addLights();
    this.scene.add(this.ground.object);
    this.scene.fog = new Fog(0xffffff, 5, 16);
  }

  paint(dark: boolean): void {
    const background = new Color(dark ? 0x161b21 : 0xf6f8fa);
    this.scene.background = background;
    this.scene.fog?.color.copy(background);
    this.sky.intensity = dark ? 1.3 : 1.9;
    this.ground.paint(dark);
  }

  /** Size in CSS pixels, each of `ratio` pixels of the picture. */
  resize(width: number, height: number, ratio: number): void {
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
  }

  /** Each view into its part of the canvas: beside each other, or below where `stacked`. */
  draw(views: View[], camera: PerspectiveCamera, gizmo: AxesGizmo, width: number, height: number, stacked: boolean): void {
    if (width < 1 || height < 1) return;
    this.renderer.setScissorTest(true);
    views.forEach((view, i) => {
      const [begin, end] = [i, i + 1].map((k) => Math.round((k / views.length) * (stacked ? height : width))) as [number, number];
      const area: Area = stacked ? [0, height - end, width, end - begin] : [begin, 0, end - begin, height];
      for (const other of views) for (const object of other.objects) object.visible = other === view;
      fit(camera, area[2] / area[3]);
      this.drawView(view, camera, area);
      gizmo.draw(this.renderer, camera, area[0], area[1]);
    });
    this.renderer.setScissorTest(false);
  }

  dispose(): void {
    this.ground.dispose();
    this.sun.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    this.canvas.remove();
  }

  private drawView(view: View, camera: PerspectiveCamera, area: Area): void {
    camera.position.add(view.shift);
    camera.updateMatrixWorld();
    this.sun.target.position.copy(view.target);
    this.sun.position.set(view.target.x - 1.2, view.target.y - 1.6, view.target.z + 4);
    this.renderer.setViewport(...area);
    this.renderer.setScissor(...area);
    this.renderer.clear();
    this.renderer.render(this.scene, camera);
    camera.position.sub(view.shift);
    camera.updateMatrixWorld();
  }

  private addLights(): void {
    this.sky.position.set(0, 0, 1);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(1024, 1024);
    this.sun.shadow.radius = 4;
    this.sun.shadow.bias = -0.0008;
    this.sun.shadow.normalBias = 0.01;
    const box = this.sun.shadow.camera;
    Object.assign(box, { left: -1.4, right: 1.4, top: 1.4, bottom: -1.4, near: 0.5, far: 9 });
    this.scene.add(this.sky, this.sun, this.sun.target);
  }
}

function fit(camera: PerspectiveCamera, aspect: number): void {
  const half = Math.tan(MathUtils.degToRad(kAngle / 2)) * Math.max(1, kLeastAspect / aspect);
  camera.fov = 2 * MathUtils.radToDeg(Math.atan(half));
  camera.aspect = aspect;
  camera.updateProjectionMatrix();
}
