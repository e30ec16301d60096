import type { BoneDriver } from 'furrow'
import { BONE } from '../../../labels/driver-forms.ts'
import { DRIVER_TYPES } from '../../../labels/drivers.ts'
import { jointsOf } from '../../../viewer/pose/joints.ts'
import { type Axis, axisOf } from '../axes.ts'
import type { FormProps } from '../context.ts'
import { DriverCurve, optionsOf, SelectField, VectorSetting } from '../fields.tsx'
import type { DriverType } from './driver-type.ts'

export const bone: DriverType<BoneDriver> = {
  label: DRIVER_TYPES.bone,
  reads: ({ joints }) => joints[1],
  axis: inputAxis,
  create: (area, _document, { joints }) =>
    joints[0] ? { type: 'bone', area, joints: joints[0], measure: 'angle', curve: CURVES.angle } : null,
  Form: BoneForm,
}

const MEASURES = [
  ['angle', BONE.angle],
  ['distance', BONE.distance],
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
        label={BONE.joint}
        value={joints[1]}
        options={optionsOf(names)}
        onChange={(joint) => set('joint', { joints: [joints[0], joint] })}
      />
      <SelectField
        label={measure === 'angle' ? BONE.relativeTo : BONE.from}
        value={joints[0]}
        options={optionsOf(names)}
        onChange={(from) => set('from', { joints: [from, joints[1]] })}
      />
      <SelectField
        label={BONE.measure}
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
          label={BONE.about}
          value={axis ? 'one' : 'any'}
          options={[
            ['any', BONE.anyAxis],
            ['one', BONE.oneAxis],
          ]}
          onChange={(next) => set('axis', { axis: next === 'one' ? [1, 0, 0] : undefined })}
        />
      )}
      {measure === 'angle' && axis && (
        <VectorSetting
          label={BONE.axis}
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
