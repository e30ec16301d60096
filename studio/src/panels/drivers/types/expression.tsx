import type { ExpressionDriver } from 'furrow'
import { EXPRESSION } from '../../../labels/driver-forms.ts'
import { DRIVER_TYPES } from '../../../labels/drivers.ts'
import { NumberSlider } from '../../controls/number-slider.tsx'
import type { FormProps } from '../context.ts'
import { NameField } from '../fields.tsx'
import { type DriverType, freeDriverName } from './driver-type.ts'

export const expression: DriverType<ExpressionDriver> = {
  label: DRIVER_TYPES.expression,
  reads: ({ name }) => name,
  create: (area, document, { pose }) => ({
    type: 'expression',
    name: freeDriverName(document, 'expression'),
    targets: [...pose].map(([name, weight]) => ({ name, weight })),
    activations: [{ area, activation: 1 }],
  }),
  Form: ExpressionForm,
}

function ExpressionForm({ driver, index, context }: FormProps<ExpressionDriver>) {
  const { name, targets, activations } = driver
  const { area, editor, pose } = context
  const own = activations.find((each) => each.area === area)
  const set = (field: string, fields: Partial<ExpressionDriver>) => {
    editor.set(index, field, fields)
    editor.settle()
  }
  return (
    <>
      <NameField label={EXPRESSION.name} value={name} onChange={(next) => set('name', { name: next })} />
      <NumberSlider
        label={EXPRESSION.activation}
        range={[0, 1, 0.01]}
        value={own?.activation ?? 0}
        onMove={(activation) => {
          const next = activations.map((each) => (each === own ? { ...each, activation } : each))
          editor.set(index, 'activation', { activations: next })
        }}
        onRest={() => editor.settle()}
      />
      <p class="hint">
        {targets.map((each) => `${each.name} ${each.weight}`).join(', ') || EXPRESSION.neutral}
      </p>
      <div class="add">
        <button
          type="button"
          onClick={() => {
            const shapes = [...pose()].map(([target, weight]) => ({ name: target, weight }))
            set('targets', { targets: shapes })
          }}
        >
          {EXPRESSION.takePose}
        </button>
      </div>
    </>
  )
}
