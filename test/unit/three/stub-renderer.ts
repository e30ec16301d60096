import { type Mesh, PerspectiveCamera, Scene, type WebGLRenderer } from 'three'

/** As much of a renderer as wrinkles call before a mesh is drawn; nothing is drawn. */
export function stubRenderer() {
  const held = { __webglTexture: true }
  return {
    info: { calls: 0, autoReset: true },
    autoClear: true,
    xr: { enabled: false },
    shadowMap: { autoUpdate: true },
    properties: { get: () => held },
    getRenderTarget: () => null,
    getActiveCubeFace: () => 0,
    getActiveMipmapLevel: () => 0,
    setRenderTarget() {},
    render() {
      this.info.calls++
    },
  }
}

/** Brings meshes up to date as a renderer does before it draws them; returns what does one frame. */
export function frameOf(...meshes: Mesh[]): () => void {
  const renderer = stubRenderer()
  const scene = new Scene()
  const camera = new PerspectiveCamera()
  return () => {
    renderer.info.calls++
    for (const mesh of meshes) {
      mesh.updateWorldMatrix(true, true)
      mesh.onBeforeRender(
        renderer as unknown as WebGLRenderer,
        scene,
        camera,
        mesh.geometry,
        mesh.material as never,
        null as never,
      )
    }
  }
}
