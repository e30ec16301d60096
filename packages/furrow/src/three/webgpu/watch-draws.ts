import type { Material, Mesh } from 'three'
import type { NodeBuilder, NodeMaterial, WebGPURenderer } from 'three/webgpu'
import type { WatchDraws } from '../loader/adoption.ts'
import { OnBeforeObjectUpdate } from './newer-nodes.ts'

const watchers = new WeakMap<Material, Parameters<WatchDraws>[1]>()

/** Watches a material as `WebGPURenderer` draws, which does not call its `onBeforeRender`, by an event in its shader graph. */
export const watchDraws: WatchDraws = (material, onDraw) => {
  if (!Object.hasOwn(material, 'setupVertex')) addEvent(material)
  watchers.set(material, onDraw)
  return () => {
    if (watchers.get(material) === onDraw) watchers.delete(material)
  }
}

/** Plain materials carry this too: the renderer copies it to the node material that it makes. It stays, and does nothing unwatched. */
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
  // Materials without the event must not use the same built shader.
  const ownKey = () => `${customProgramCacheKey.call(material)} furrow watched`
  Object.assign(material, { setupVertex, customProgramCacheKey: ownKey })
}
