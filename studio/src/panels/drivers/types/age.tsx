import { AGES, type AgeDriver } from 'furrow/internal'
import { AGE } from '../../../labels/driver-forms.ts'
import { DRIVER_TYPES } from '../../../labels/drivers.ts'
import { type Axis, axisOf } from '../axes.ts'
import type { FormProps } from '../context.ts'
import { DriverCurve } from '../fields.tsx'
import { InputSlider } from '../input-slider.tsx'
import type { DriverType } from './driver-type.ts'

export const age: DriverType<AgeDriver> = {
  label: DRIVER_TYPES.age,
  axis: inputAxis,
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

/** Returns the input axis of the driver's curve. */
function inputAxis({ curve }: AgeDriver): Axis {
  return axisOf('age', AGE.input, curve)
}

function AgeForm({ driver, index, context }: FormProps<AgeDriver>) {
  const { curve } = driver
  const axis = inputAxis(driver)
  return (
    <>
      <DriverCurve {...{ index, context, curve, axis }} />
      <InputSlider name="age" label={AGE.now} axis={axis} context={context} />
    </>
  )
}
