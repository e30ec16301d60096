import type { AreaDriver } from 'furrow'
import { RULES } from '../../../labels/driver-forms.ts'
import { DRIVER_TYPES, LINKS } from '../../../labels/drivers.ts'
import { type Axis, axisOf } from '../axes.ts'
import type { FormProps } from '../context.ts'
import { DriverCurve } from '../fields.tsx'
import { LinkList } from '../link-list.tsx'
import { type DriverType, namesOf } from './driver-type.ts'
import { RuleField } from './rule-field.tsx'

export const area: DriverType<AreaDriver> = {
  label: DRIVER_TYPES.area,
  reads: ({ areas }) => namesOf(areas),
  axis: inputAxis,
  create: (area, { areas }) => {
    const other = areas.find(({ name }) => name !== area)
    return other ? { type: 'area', area, areas: [{ name: other.name }] } : null
  },
  Form: AreaForm,
}

/** Returns the input axis of the driver's curve. */
function inputAxis({ areas, curve }: AreaDriver): Axis {
  return axisOf('fraction', areas.length === 1 ? areas[0].name : RULES.together, curve)
}

function AreaForm({ driver, index, context }: FormProps<AreaDriver>) {
  const { areas, rule, curve } = driver
  const others = context.areas.filter((name) => name !== context.area)
  return (
    <>
      <LinkList {...{ index, context }} links={areas} names={others} noun={LINKS.area} field="areas" />
      {areas.length > 1 && <RuleField {...{ rule, index, context }} />}
      <DriverCurve {...{ index, context, curve }} axis={inputAxis(driver)} />
    </>
  )
}
