import type { Material } from 'three'
import {
  cameraViewMatrix,
  int,
  Loop,
  normalMap,
  normalView,
  normalWorld,
  select,
  texture,
  vec3,
} from 'three/tsl'
import type { Node, NodeBuilder, NodeMaterial } from 'three/webgpu'
import type { PaperArray } from '../../material/paper-array.ts'
import { sRGBTransferEOTF } from '../newer-nodes.ts'
import { materialProperty, normalInView, normalScale, typed } from '../node.ts'
import type { Added } from '../patch/patch-nodes.ts'
import { repeat } from '../texture-sampling.ts'

/**
 * Creates the nodes of the mode `paper`, the method of the paper in docs/paper.md. They compute the lighting with the smooth normals and
 * again with the wrinkled normals. They mix the two colours by the influence of the wrinkles.
 */
export function paperNodes(
  material: Material,
  { texture: colours, diffuseIsSrgb }: PaperArray,
  uv: Node<'vec2'>,
  influence: Node<'vec4'>,
): Added {
  const sample = (slice: number) => texture(colours, repeat(uv)).depth(int(slice))
  const smooth = normalMap(sample(1).xyz, normalScale(material))
  const wrinkled = normalMap(sample(2).xyz, normalScale(material))
  const stored = sample(0).rgb
  const diffuse = diffuseIsSrgb ? typed<'vec3'>(sRGBTransferEOTF(stored)) : stored
  return {
    colorNode: materialProperty('color', 'color', material).mul(diffuse),
    normalNode: smooth,
    setupLighting(this: NodeMaterial, builder: NodeBuilder) {
      // A loop runs one lighting graph twice. If the graph were built twice, both copies would use the same variables.
      const colour = vec3(0).toVar()
      const normals = [normalInView(smooth).toVar(), normalInView(wrinkled).toVar()]
      const amount = influence.x.toVar()
      Loop(2, ({ i }) => {
        const isSecond = int(i).equal(1)
        normalView.assign(select(isSecond, normals[1], normals[0]))
        normalWorld.assign(normalView.transformNormalByInverseViewMatrix(cameraViewMatrix))
        const lit = vec3(Object.getPrototypeOf(this).setupLighting.call(this, builder))
        colour.addAssign(lit.mul(select(isSecond, amount, amount.oneMinus())))
      })
      return colour
    },
  }
}
