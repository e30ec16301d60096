import type { MuscleDriver } from 'furrow'
import { MUSCLE } from '../../../labels/driver-forms.ts'
import { DRIVER_TYPES } from '../../../labels/drivers.ts'
import { NumberSlider } from '../../controls/number-slider.tsx'
import type { FormProps } from '../context.ts'
import { NameField, NumberSetting, SelectField, VectorSetting } from '../fields.tsx'
import { type DriverType, freeDriverName } from './driver-type.ts'

export const muscle: DriverType<MuscleDriver> = {
  label: DRIVER_TYPES.muscle,
  reads: ({ name }) => name,
  create: (area, document, face) => {
    const axis = face.muscle()
    return axis && { type: 'muscle', name: freeDriverName(document, 'muscle'), area, ...axis }
  },
  Form: MuscleForm,
}

const KINDS: readonly (readonly [MuscleDriver['kind'], string])[] = [
  ['linear', MUSCLE.linear],
  ['sheet', MUSCLE.sheet],
  ['sphincter', MUSCLE.sphincter],
]

const DEGREES = 180 / Math.PI

/** Form for a virtual muscle: both ends, range and strength. */
function MuscleForm({ driver, index, context }: FormProps<MuscleDriver>) {
  const { kind, origin, insertion, angle, width, inner, outer } = driver
  const { editor } = context
  // Positions are stored in metres and displayed in millimetres.
  const set = (fields: Partial<MuscleDriver>) => {
    editor.set(index, Object.keys(fields)[0], fields)
    editor.settle()
  }
  const slider = (label: string, field: 'strength' | 'inner' | 'outer', range: [number, number]) => (
    <NumberSlider
      label={label}
      range={[...range, 0.01]}
      value={driver[field]}
      onMove={(value) => editor.set(index, field, { [field]: value })}
      onRest={() => editor.settle()}
    />
  )
  return (
    <>
      <NameField label={MUSCLE.name} value={driver.name} onChange={(name) => set({ name })} />
      <p class="hint">{MUSCLE.hint}</p>
      <SelectField
        label={MUSCLE.fibres}
        value={kind}
        options={KINDS}
        onChange={(next) => set({ kind: next as MuscleDriver['kind'] })}
      />
      {slider(MUSCLE.strength, 'strength', [-1, 1])}
      {slider(MUSCLE.inner, 'inner', [0, Math.min(2, outer - 0.01)])}
      {slider(MUSCLE.outer, 'outer', [inner + 0.01, Math.max(2, outer)])}
      {kind === 'linear' ? (
        <NumberSetting
          label={MUSCLE.angle}
          value={angle * DEGREES}
          step={1}
          range={[1, 89]}
          unit="°"
          onChange={(next) => set({ angle: next / DEGREES })}
        />
      ) : (
        <NumberSetting
          label={MUSCLE.width}
          value={width * 1000}
          step={1}
          range={[0.1, 1000]}
          unit="mm"
          onChange={(next) => set({ width: next / 1000 })}
        />
      )}
      <VectorSetting
        label={kind === 'sphincter' ? MUSCLE.centre : MUSCLE.bone}
        value={origin}
        step={1}
        factor={1000}
        unit="mm"
        onChange={(next) => set({ origin: next })}
      />
      <VectorSetting
        label={kind === 'sphincter' ? MUSCLE.edge : MUSCLE.skin}
        value={insertion}
        step={1}
        factor={1000}
        unit="mm"
        onChange={(next) => set({ insertion: next })}
      />
    </>
  )
}
