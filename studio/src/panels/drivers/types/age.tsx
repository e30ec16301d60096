import { AGES, type AgeDriver } from 'furrow/internal'
import { axisOf } from '../axes.ts'
import type { FormProps } from '../context.ts'
import { DriverCurve } from '../fields.tsx'
import { InputSlider } from '../input-slider.tsx'
import type { DriverType } from './driver-type.ts'

export const age: DriverType<AgeDriver> = {
  label: 'Age',
  create: (area) => ({
    type: 'age',
    area,
    curve: [
      [30, 0],
      [AGES.oldest, 1],
    ],
  }),
  Form: AgeForm,
}

function AgeForm({ driver: { curve }, index, context }: FormProps<AgeDriver>) {
  const axis = axisOf('age', 'Age, years', curve)
  return (
    <>
      <DriverCurve {...{ index, context, curve, axis }} />
      <InputSlider name="age" label="Age now" axis={axis} context={context} />
    </>
  )
}
