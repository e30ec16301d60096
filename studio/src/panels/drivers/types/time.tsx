import type { TimeDriver } from 'furrow'
import { DELAY } from '../../../labels/driver-forms.ts'
import { DRIVER_TYPES } from '../../../labels/drivers.ts'
import { NumberSlider } from '../../controls/number-slider.tsx'
import type { FormProps } from '../context.ts'
import type { DriverType } from './driver-type.ts'

export const time: DriverType<TimeDriver> = {
  label: DRIVER_TYPES.time,
  create: (area) => ({ type: 'time', area, attack: 0.1, release: 0.4 }),
  Form: TimeForm,
}

function TimeForm({ driver, index, context: { editor } }: FormProps<TimeDriver>) {
  const slider = (label: string, field: 'attack' | 'release') => (
    <NumberSlider
      label={label}
      range={[0, Math.max(2, driver[field]), 0.01]}
      value={driver[field]}
      onMove={(value) => editor.set(index, field, { [field]: value })}
      onRest={() => editor.settle()}
    />
  )
  return (
    <>
      {slider(DELAY.attack, 'attack')}
      {slider(DELAY.release, 'release')}
      <p class="hint">{DELAY.hint}</p>
    </>
  )
}
