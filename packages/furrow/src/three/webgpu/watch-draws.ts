import type { Material, Mesh } from 'three'
import type { NodeBuilder, NodeMaterial, WebGPURenderer } from 'three/webgpu'
import type { WatchDraws } from '../loader/adoption.ts'
import { OnBeforeObjectUpdate } from './newer-nodes.ts'

const watchers = new WeakMap<Material, Parameters<WatchDraws>[1]>()

/** Watches draws of a material by an event in its shader graph, because `WebGPURenderer` does not call `Material.onBeforeRender`. */
export const watchDraws: WatchDraws = (material, onDraw) => {
  if (!Object.hasOwn(material, 'setupVertex')) addEvent(material)
  watchers.set(material, onDraw)
  return () => {
    if (watchers.get(material) === onDraw) watchers.delete(material)
  }
}

/** Adds the event permanently. Non-node materials can carry it too: the renderer copies it to its node material. */
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
