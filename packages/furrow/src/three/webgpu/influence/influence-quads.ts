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
      // Otherwise three.js draws transparent back and front faces separately, with one pipeline each.
      forceSinglePass: true,
    })
  },
  // A lost device is never restored; pages create a new renderer.
  hasContents: () => true,
}

/** Creates a material of `Quads` that overwrites the target. */
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

/** Position of a `Quads` vertex in the target, 0..1. */
export function targetUv(): Node<'vec2'> {
  return attribute('furrowPoint', 'vec4').xy
}

/** Clip position of a `Quads` vertex. Row 0 of the target is at the top: three.js flips render targets on both backends. */
function clipPosition(): Node<'vec4'> {
  return vec4(targetUv().mul(vec2(2, -2)).add(vec2(-1, 1)), 0, 1)
}

/** Weight of the area times its activation, in the channel of its layer. */
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
