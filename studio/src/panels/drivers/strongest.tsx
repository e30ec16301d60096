import type { Link, WrinkleDriver } from 'furrow'
import { canonicalTargetName } from 'furrow/internal'
import { fullLabel, WHEN } from '../../labels/drivers.ts'
import { blendshapeLabel, expressionLabel, nameLabel, regionLabel } from '../../labels/names.ts'
import type { DriverContext } from './context.ts'
import { DriverCurve } from './fields.tsx'
import { LinkCurve } from './link-list.tsx'
import { type StrongInput, strongestInputs } from './strongest-inputs.ts'
import { driverTypeOf } from './types/types.ts'

/** Maximum number of inputs. */
const MOST = 3

interface StrongestProps {
  drivers: readonly WrinkleDriver[]
  context: DriverContext
}

/** Strongest inputs of an area's drivers: a bar with the activation that each gives when it is full, and its curve. */
export function Strongest({ drivers, context }: StrongestProps) {
  const inputs = strongestInputs(drivers, context.area, MOST)
  if (inputs.length === 0) {
    const isAlwaysVisible = (context.model.areas.chosen.value?.activation ?? 0) > 0
    return <p class="hint">{isAlwaysVisible ? WHEN.always : WHEN.noDriver}</p>
  }
  return (
    <section class="strongest" aria-label={WHEN.strongest}>
      <h3>{WHEN.strongest}</h3>
      {inputs.map((input) => (
        <Row
          key={`${input.index} ${input.link} ${drivers[input.index].type}`}
          input={input}
          driver={drivers[input.index]}
          context={context}
        />
      ))}
    </section>
  )
}

interface RowProps {
  input: StrongInput
  driver: WrinkleDriver
  context: DriverContext
}

function Row({ input: { index, link, names, full }, driver, context }: RowProps) {
  const label = labelOf(driver, names)
  const fileName = names.join(', ')
  const heading = (
    <>
      <span class="cause">
        {label} {fileName !== '' && <small>{fileName}</small>}
      </span>
      <meter aria-label={label} title={fullLabel(full)} max={1} value={Number(full.toFixed(2))} />
    </>
  )
  const curve = <Curve {...{ index, link, driver, context }} />
  if (!driverTypeOf(driver.type)?.axis) return <div class="strong">{heading}</div>
  return (
    <details class="strong">
      <summary>{heading}</summary>
      {curve}
    </details>
  )
}

/** Editor for the curve of one of several inputs, or of the whole driver. */
function Curve({ index, link, driver, context }: Omit<RowProps, 'input'> & { index: number; link: number }) {
  const type = driverTypeOf(driver.type)
  const { targets, areas, curve } = driver as { targets?: Link[]; areas?: Link[]; curve?: [number, number][] }
  const links = targets ?? areas
  if (links && links.length > 1 && link >= 0)
    return <LinkCurve {...{ index, context, links }} position={link} field={targets ? 'targets' : 'areas'} />
  return type?.axis && curve ? <DriverCurve {...{ index, context, curve }} axis={type.axis(driver)} /> : null
}

/** Returns the everyday name of a driver's inputs, or of its type if its inputs have no names. */
function labelOf({ type }: WrinkleDriver, names: readonly string[]): string {
  if (names.length === 0) return driverTypeOf(type)?.label ?? type
  const label = LABELS[type] ?? nameLabel
  return names.map((name) => label(name)).join(' + ')
}

const LABELS: Readonly<Record<string, (name: string) => string>> = {
  morph: (name) => blendshapeLabel(canonicalTargetName(name)),
  area: regionLabel,
  expression: expressionLabel,
}
