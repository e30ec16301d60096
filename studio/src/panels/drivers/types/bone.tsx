import type { BoneDriver } from 'furrow'
import { jointsOf } from '../../../viewer/pose/joints.ts'
import { type Axis, axisOf } from '../axes.ts'
import type { FormProps } from '../context.ts'
import { DriverCurve, optionsOf, SelectField, VectorSetting } from '../fields.tsx'
import type { DriverType } from './driver-type.ts'

export const bone: DriverType<BoneDriver> = {
  label: 'Joint',
  reads: ({ joints }) => joints[1],
  axis: inputAxis,
  create: (area, _document, { joints }) =>
    joints[0] ? { type: 'bone', area, joints: joints[0], measure: 'angle', curve: CURVES.angle } : null,
  Form: BoneForm,
}

const MEASURES = [
  ['angle', 'Angle'],
  ['distance', 'Distance'],
] as const

/** Returns the input axis of the driver's curve. */
function inputAxis({ measure, joints, curve }: BoneDriver): Axis {
  return axisOf(measure, joints[1], curve)
}

function BoneForm({ driver, index, context }: FormProps<BoneDriver>) {
  const { joints, measure, axis, curve } = driver
  const { editor, model } = context
  const root = model.viewer.value?.avatar.root
  const names = [...new Set((root ? jointsOf(root) : []).flat())]
  const set = (field: string, fields: Partial<BoneDriver> | { axis: undefined }) => {
    editor.set(index, field, fields)
    editor.settle()
  }
  return (
    <>
      <SelectField
        label="Joint"
        value={joints[1]}
        options={optionsOf(names)}
        onChange={(joint) => set('joint', { joints: [joints[0], joint] })}
      />
      <SelectField
        label={measure === 'angle' ? 'Relative to' : 'From'}
        value={joints[0]}
        options={optionsOf(names)}
        onChange={(from) => set('from', { joints: [from, joints[1]] })}
      />
      <SelectField
        label="Measure"
        value={measure}
        options={MEASURES}
        // A curve for angles does not suit distances.
        onChange={(next) =>
          set('measure', {
            measure: next as BoneDriver['measure'],
            curve: CURVES[next as BoneDriver['measure']],
          })
        }
      />
      {measure === 'angle' && (
        <SelectField
          label="About"
          value={axis ? 'one' : 'any'}
          options={[
            ['any', 'Any axis'],
            ['one', 'One axis'],
          ]}
          onChange={(next) => set('axis', { axis: next === 'one' ? [1, 0, 0] : undefined })}
        />
      )}
      {measure === 'angle' && axis && (
        <VectorSetting
          label="Axis at rest"
          value={axis}
          step={0.1}
          onChange={(next) => set('axis', { axis: next })}
        />
      )}
      <DriverCurve {...{ index, context, curve }} axis={inputAxis(driver)} />
    </>
  )
}

/** Default curves. Their inputs are radians for angles, and metres for distances. */
const CURVES: Record<BoneDriver['measure'], BoneDriver['curve']> = {
  angle: [
    [0, 0],
    [1.57, 1],
  ],
  distance: [
    [0, 0],
    [0.1, 1],
  ],
}
