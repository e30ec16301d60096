import type { Controller, GUI } from 'three/addons/libs/lil-gui.module.min.js'
import type { DriverPart, Explanation } from '../drivers/explain.ts'
import type { WrinklesBase } from '../three/wrinkles-base.ts'

/** Maximum number of inputs listed below an area. Weaker inputs are left out. */
const MAX_INPUTS = 3

/** Controls of one area. */
interface Row {
  slider: Pick<Controller, 'destroy'> & { updateDisplay(): unknown }
  /** Line of text with the inputs that drive the area. */
  drivers: HTMLElement
}

/** List of the areas of one face. Each area has a slider for its activation, and a line of text with the inputs that drive the area. */
export class AreaList {
  /** Index of the instance whose activations are listed, for instanced meshes. */
  instance = 0
  readonly #wrinkles: WrinklesBase
  readonly #folder: GUI
  #values: Record<string, number> = {}
  #rows = new Map<string, Row>()

  constructor(wrinkles: WrinklesBase, folder: GUI) {
    this.#wrinkles = wrinkles
    this.#folder = folder
    this.#build()
  }

  /** Updates the list to the current areas and activations. */
  update(): void {
    const explanations = this.#wrinkles.explain(this.instance)
    if (explanations.map(({ area }) => area).join() !== [...this.#rows.keys()].join()) this.#build()
    for (const explanation of explanations) this.#show(explanation)
  }

  #build(): void {
    for (const { slider, drivers } of this.#rows.values()) {
      slider.destroy()
      drivers.remove()
    }
    const names = this.#wrinkles.areaNames
    this.#values = Object.fromEntries(names.map((name) => [name, 0]))
    this.#rows = new Map(names.map((name) => [name, this.#addRow(name)]))
  }

  #addRow(name: string): Row {
    const slider = this.#folder.add(this.#values, name, 0, 1)
    slider.decimals(2).onChange((value: number) => this.#set(name, value))
    const drivers = document.createElement('div')
    drivers.style.cssText = 'padding: 0 8px 4px; opacity: 0.6; overflow-wrap: anywhere'
    slider.domElement.after(drivers)
    return { slider, drivers }
  }

  /** Sets the activation of an area by hand. Stops the drivers, because they would overwrite the activation in the next frame. */
  #set(name: string, value: number): void {
    const wrinkles = this.#wrinkles
    if (wrinkles.isDriven(name)) wrinkles.driven = false
    wrinkles.setActivation(name, value, this.instance)
  }

  #show({ area, activation, resting, parts }: Explanation): void {
    const { slider, drivers } = this.#rows.get(area)!
    this.#values[area] = activation
    slider.updateDisplay()
    const text = this.#wrinkles.driven ? driversText(parts, resting) : 'set by hand'
    if (drivers.textContent !== text) drivers.textContent = text
  }
}

/** Returns the strongest inputs with their contributions, e.g. `browInnerUp 0.42, age 0.10`. If no input is active, returns names only. */
function driversText(parts: readonly DriverPart[], resting: number): string {
  const inputs = parts.flatMap(({ driver, activation, links }) =>
    links.length > 0
      ? links.map(({ link, value }) => ({ name: link.name, value: activation > 0 ? value : 0 }))
      : [{ name: driver.type, value: activation }],
  )
  if (resting > 0) inputs.push({ name: 'at rest', value: resting })
  if (inputs.length === 0) return 'no drivers'
  const active = inputs.filter(({ value }) => value > 0.005).sort((a, b) => b.value - a.value)
  const listed = active.length > 0 ? active : inputs
  const texts = listed
    .slice(0, MAX_INPUTS)
    .map(({ name, value }) => (active.length > 0 ? `${name} ${value.toFixed(2)}` : name))
  const more = listed.length - texts.length
  return texts.join(', ') + (more > 0 ? `, +${more}` : '')
}
