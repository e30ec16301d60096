import { AddEquation, CustomBlending, DoubleSide, MaxEquation, NoBlending, OneFactor } from 'three'
import { attribute, Fn, floor, int, ivec2, textureLoad, varying, vec2, vec4 } from 'three/tsl'
import { type Node, NodeMaterial } from 'three/webgpu'
import type { AreaArray } from '../../atlas/area-array.ts'
import type { QuadMaterials } from '../../atlas/quad-materials.ts'
import { channelMask } from './influence.ts'

/** Materials that draw influence maps with `WebGPURenderer`. */
export const quadMaterials: QuadMaterials = {
  create(rule, areas) {
    return Object.assign(quadMaterial(rule, areas ? weightedActivation(areas) : vec4(0)), {
      blending: rule === 'clear' ? NoBlending : CustomBlending,
      blendEquation: rule === 'max' ? MaxEquation : AddEquation,
      blendSrc: OneFactor,
      blendDst: OneFactor,
      transparent: true,
      // Otherwise three.js would draw back and front sides of transparent objects separately, with one pipeline each.
      forceSinglePass: true,
    })
  },
  // Contents are lost only with the WebGPU device. Unlike a WebGL context, a lost device is never restored: the page must create a new renderer.
  hasContents: () => true,
}

/** Creates a material for `Quads` that overwrites the texels of the render target. */
export function quadMaterial(name: string, fragment: Node<'vec4'>): NodeMaterial {
  return Object.assign(new NodeMaterial(), {
    name: `furrow ${name}`,
    vertexNode: clipPosition(),
    fragmentNode: fragment,
    blending: NoBlending,
    side: DoubleSide,
    depthTest: false,
    depthWrite: false,
    fog: false,
    lights: false,
    toneMapped: false,
  })
}

/** Returns the position of a vertex of `Quads` in the render target, 0..1. */
export function targetUv(): Node<'vec2'> {
  return attribute('furrowPoint', 'vec4').xy
}

/**
 * Returns the clip position of a vertex of `Quads`. Row 0 of a render target is at y = 1, because three.js flips render targets on both
 * backends.
 */
function clipPosition(): Node<'vec4'> {
  return vec4(targetUv().mul(vec2(2, -2)).add(vec2(-1, 1)), 0, 1)
}

/** Returns the weight of an area times its activation, in the channel of the area's layer. */
function weightedActivation({ texture, channels }: AreaArray): Node<'vec4'> {
  return Fn(() => {
    const texel = varying(attribute('furrowPoint', 'vec4').zw)
    const { x: activation, y: packed } = attribute('furrowSource', 'vec2')
    const source = varying(floor(vec2(packed.div(16), packed.mod(16).div(4))))
    const stored = textureLoad(texture, ivec2(texel)).depth(int(source.x.add(0.5)))
    const weight = channels === 1 ? stored.x : stored.dot(channelMask(source.y))
    return varying(channelMask(packed.mod(4)).mul(activation)).mul(weight)
  })()
}
