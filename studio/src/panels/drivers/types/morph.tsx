import type { MorphDriver } from 'furrow'
import { RULES } from '../../../labels/driver-forms.ts'
import { DRIVER_TYPES, LINKS } from '../../../labels/drivers.ts'
import { type Axis, axisOf } from '../axes.ts'
import type { FormProps } from '../context.ts'
import { DriverCurve } from '../fields.tsx'
import { LinkList } from '../link-list.tsx'
import { type DriverType, namesOf } from './driver-type.ts'
import { RuleField } from './rule-field.tsx'

export const morph: DriverType<MorphDriver> = {
  label: DRIVER_TYPES.morph,
  reads: ({ targets }) => namesOf(targets),
  axis: inputAxis,
  create: (area, _document, { pose, targets }) => {
    const [strongest] = [...pose].sort(([, a], [, b]) => b - a)
    const name = strongest?.[0] ?? targets[0]
    return name === undefined ? null : { type: 'morph', area, targets: [{ name }] }
  },
  Form: MorphForm,
}

/** Returns the input axis of the driver's curve. */
function inputAxis({ targets, curve }: MorphDriver): Axis {
  return axisOf('fraction', targets.length === 1 ? targets[0].name : RULES.together, curve)
}

function MorphForm({ driver, index, context }: FormProps<MorphDriver>) {
  const { targets, rule, curve } = driver
  return (
    <>
      <LinkList
        {...{ index, context }}
        links={targets}
        names={context.targets}
        noun={LINKS.blendshape}
        field="targets"
      />
      {targets.length > 1 && <RuleField {...{ rule, index, context }} />}
      <DriverCurve {...{ index, context, curve }} axis={inputAxis(driver)} />
    </>
  )
}
