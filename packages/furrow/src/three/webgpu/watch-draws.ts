import type { Material, Mesh } from 'three'
import type { NodeBuilder, NodeMaterial, WebGPURenderer } from 'three/webgpu'
import type { WatchDraws } from '../loader/adoption.ts'
import { OnBeforeObjectUpdate } from './newer-nodes.ts'

const watchers = new WeakMap<Material, Parameters<WatchDraws>[1]>()

/**
 * Calls a function before `WebGPURenderer` draws any mesh that has the material, see `WatchDraws`. Uses an event in the shader graph, because
 * `WebGPURenderer` does not call `Material.onBeforeRender`.
 */
export const watchDraws: WatchDraws = (material, onDraw) => {
  if (!Object.hasOwn(material, 'setupVertex')) addEvent(material)
  watchers.set(material, onDraw)
  return () => {
    if (watchers.get(material) === onDraw) watchers.delete(material)
  }
}

/**
 * Adds the event permanently. This also works on a material that is not a node material, because the renderer draws it with a node material to
 * which it copies all properties.
 */
function addEvent(material: Material): void {
  const setupVertex = function (this: NodeMaterial, builder: NodeBuilder) {
    OnBeforeObjectUpdate(({ material: drawn, object, renderer, camera, scene }) => {
      const onDraw = drawn && watchers.get(drawn)
      if (onDraw && (object as Mesh).isMesh)
        onDraw(object as Mesh, renderer as WebGPURenderer, camera!, scene!)
    })
    return Object.getPrototypeOf(this).setupVertex.call(this, builder)
  }
  const { customProgramCacheKey } = material
  // Materials without the event must not share the shader.
  const ownKey = () => `${customProgramCacheKey.call(material)} furrow watched`
  Object.assign(material, { setupVertex, customProgramCacheKey: ownKey })
}
