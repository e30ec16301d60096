import { AddEquation, CustomBlending, DoubleSide, MaxEquation, NoBlending, OneFactor } from 'three'
import { attribute, Fn, int, ivec2, mix, positionGeometry, textureLoad, varying, vec2, vec4 } from 'three/tsl'
import { type Node, NodeMaterial } from 'three/webgpu'
import type { AreaArray } from '../atlas/area-array.ts'
import type { QuadMaterials } from '../atlas/influence-pass.ts'
import { channelMask } from './influence.ts'

/** The materials that draw influence maps on `WebGPURenderer`, on WebGPU and on its WebGL 2 backend. */
export const quadMaterials: QuadMaterials = {
  create(rule, areas) {
    const material = quadMaterial(rule, areas ? share(areas) : (vec4(0) as unknown as Node<'vec4'>))
    material.blending = rule === 'clear' ? NoBlending : CustomBlending
    material.blendEquation = rule === 'max' ? MaxEquation : AddEquation
    material.blendSrc = OneFactor
    material.blendDst = OneFactor
    material.transparent = true
    return material
  },
  // A device that is lost does not come back; the page makes another renderer.
  hasContents: () => true,
}

/** A material of `Quads`, drawn over whatever stands there. */
export function quadMaterial(what: string, fragment: Node<'vec4'>): NodeMaterial {
  const material = new NodeMaterial()
  material.name = `furrow ${what}`
  material.vertexNode = corner()
  material.fragmentNode = fragment
  material.blending = NoBlending
  material.side = DoubleSide
  material.depthTest = false
  material.depthWrite = false
  material.fog = false
  material.lights = false
  material.toneMapped = false
  return material
}

function vector(name: string): Node<'vec4'> {
  return attribute(name, 'vec4') as unknown as Node<'vec4'>
}

/** The point of the target, 0..1, where a vertex of `Quads` lies. */
export function quadPlace(): Node<'vec2'> {
  const to = vector('furrowTo')
  return mix(to.xy, to.zw, positionGeometry.xy) as unknown as Node<'vec2'>
}

/** Its position. Row 0 of the target is at the top: three.js turns render targets so on both backends. */
function corner(): Node<'vec4'> {
  return vec4(quadPlace().mul(vec2(2, -2)).add(vec2(-1, 1)), 0, 1) as unknown as Node<'vec4'>
}

function share({ texture, channels }: AreaArray): Node<'vec4'> {
  return Fn(() => {
    const from = vector('furrowFrom')
    const texel = varying(mix(from.xy, from.zw, positionGeometry.xy) as Node<'vec2'>)
    const at = varying(vector('furrowAt'))
    const stored = textureLoad(texture, ivec2(texel)).depth(int(at.x.add(0.5))) as unknown as Node<'vec4'>
    const weight = channels === 1 ? stored.x : stored.dot(channelMask(at.y as Node<'float'>))
    return varying(vector('furrowShare')).mul(weight)
  })() as unknown as Node<'vec4'>
}
