import {
  VRMExpression,
  VRMExpressionManager,
  VRMExpressionMorphTargetBind,
  VRMExpressionOverrideType,
} from '@pixiv/three-vrm-core'
import { VrmWeights } from 'furrow/internal'
import { addDrivers, Wrinkles } from 'furrow/three'
import { describe, expect, it } from 'vitest'
import { blendMesh } from '../../blend-mesh.ts'
import { randomSet } from '../../cases.ts'
import { morph } from '../../drivers.ts'
import { seeded } from '../../random.ts'
import { frameOf } from '../three/stub-renderer.ts'

/** Makes a face with a three-vrm expression manager. Each expression moves one blendshape, and some override others. */
function avatar() {
  const names = ['blink', 'blinkLeft', 'aa', 'lookUp', 'happy', 'surprised']
  const mesh = blendMesh(...names.map((name) => `shape_${name}_x`))
  const manager = new VRMExpressionManager()
  for (const [index, name] of names.entries()) {
    const expression = new VRMExpression(name)
    expression.addBind(new VRMExpressionMorphTargetBind({ primitives: [mesh], index, weight: 1 }))
    manager.registerExpression(expression)
  }
  const of = (name: string) => manager.getExpression(name)!
  of('happy').overrideBlink = VRMExpressionOverrideType.Blend
  of('happy').overrideMouth = VRMExpressionOverrideType.Block
  of('surprised').overrideLookAt = VRMExpressionOverrideType.Blend
  of('blinkLeft').isBinary = true
  return { mesh, manager, names }
}

describe('VrmWeights', () => {
  it('equal the weights that three-vrm applies to the mesh, for random weights', () => {
    const { mesh, manager, names } = avatar()
    const vrm = new VrmWeights(manager)
    const weights = new Float32Array(names.length)
    const random = seeded(9)
    expect(vrm.names).toEqual(names)
    for (let i = 0; i < 200; i++) {
      for (const name of names) manager.setValue(name, random() < 0.3 ? 0 : random())
      manager.update()
      vrm.writeTo(weights, 0)
      for (const [k, shown] of mesh.morphTargetInfluences!.entries()) expect(weights[k]).toBeCloseTo(shown, 6)
    }
  })

  it('are read by drivers that name expressions, after overrides', () => {
    const { mesh, manager } = avatar()
    const wrinkles = new Wrinkles(mesh, randomSet(seeded(1), 1, 8))
    const [area] = wrinkles.areaNames
    addDrivers(wrinkles, [morph(area, 'blink')], { expressions: manager })
    const frame = frameOf(mesh)
    const shown = (values: Record<string, number>) => {
      for (const [name, value] of Object.entries(values)) manager.setValue(name, value)
      manager.update()
      frame()
      return wrinkles.getActivation(area)
    }
    expect(shown({ blink: 0.8 })).toBeCloseTo(0.8, 6)
    expect(shown({ happy: 0.75 })).toBeCloseTo(0.2, 6)
    expect(shown({ happy: 0 })).toBeCloseTo(0.8, 6)
  })
})
