import type { Mesh } from 'three'
import { FurrowError } from '../core/error.ts'
import type { Area, ArraySlice } from '../core/types.ts'
import { AGES } from '../drivers/age.ts'
import type { Expression } from '../drivers/expression.ts'
import type { AreaArray } from './atlas/area-array.ts'
import type { AnyRenderer } from './atlas/influence-atlas.ts'
import { Face } from './face.ts'
import { countFaces } from './instances.ts'

/** Brings one face's activations up to date. */
type Drive = (face: Face, instance: number, renderer: AnyRenderer) => void

/** The areas of a mesh, or of each instance of it, with their activations and what drives them; nothing here draws. */
export abstract class DrivenFaces {
  readonly mesh: Mesh
  /** Whether the drivers of the file move their areas; set it to false to move them yourself. */
  driven = true
  /** Presets that the file brings. */
  expressions: readonly Expression[] = []
  /** Tells milliseconds to drivers that take their time; replace it where frames are not drawn as time passes. */
  clock: { now(): number } = performance

  /** One for each instance. */
  protected readonly faces: readonly Face[]
  protected areas: Area<ArraySlice>[]
  #age: number = AGES.youngest
  readonly #drivers: Drive[] = []
  /** Areas that drivers set in every frame, whatever they were set to. */
  #driven: ReadonlySet<string> = new Set()
  readonly #disposers: (() => void)[] = []

  /** @param array the areas, packed in their order. */
  constructor(mesh: Mesh, areas: readonly Area<ArraySlice>[], array: AreaArray) {
    this.mesh = mesh
    this.areas = [...areas]
    this.faces = Array.from({ length: countFaces(mesh) }, (_, instance) => {
      return new Face(array, this.areas, (face, renderer) => {
        if (this.driven) for (const drive of this.#drivers) drive(face, instance, renderer)
      })
    })
  }

  /** Names of the areas, in the order they are packed. */
  get areaNames(): string[] {
    return this.areas.map(({ name }) => name)
  }

  /** One of the areas as it was given. */
  getArea(name: string): Area<ArraySlice> | undefined {
    return this.areas.find((area) => area.name === name)
  }

  /** Whether an area of that name exists. */
  hasArea(name: string): boolean {
    return this.faces[0].activations.has(name)
  }

  /**
   * @param value 0..1; clamped with one warning.
   * @param instance of an `InstancedMesh` or `BatchedMesh`; 0 unless told.
   * @throws FurrowError when no area has that name.
   */
  setActivation(area: string, value: number, instance = 0): void {
    const face = this.faces[instance]
    // What nothing else moves stays as it is set; age adds to it, and delays follow it.
    if (this.#driven.has(area)) face.activations.set(area, value)
    else face.rest(area, value)
  }

  /**
   * The same for many at once; names that no area has are passed over, and nothing is allocated.
   *
   * @param values 0..1, in the order of the names.
   */
  setActivations(names: readonly string[], values: Float32Array, instance = 0): void {
    const { activations, resting } = this.faces[instance]
    activations.takeNamed(names, values)
    resting.takeNamed(names, values, this.#driven)
  }

  /** @throws FurrowError when no area has that name. */
  getActivation(area: string, instance = 0): number {
    return this.faces[instance].activations.get(area)
  }

  /**
   * Changes an area's activation at rest, to which drivers add: key frames of a file do, and so may you.
   *
   * @param value 0..1; clamped with one warning.
   * @throws FurrowError when no area has that name.
   */
  setRestingActivation(area: string, value: number, instance = 0): void {
    this.faces[instance].rest(area, value)
  }

  /** @throws FurrowError when no area has that name. */
  getRestingActivation(area: string, instance = 0): number {
    return this.faces[instance].resting.get(area)
  }

  /** The person's age in years, for areas with drivers of type `age`; 20 unless told. */
  get age(): number {
    return this.#age
  }

  /** @throws FurrowError when it is no number. */
  set age(years: number) {
    if (!Number.isFinite(years)) {
      throw new FurrowError({
        who: 'Wrinkles.age',
        what: 'no age',
        value: years,
        limit: 'a number of years; faces change from 20 to 80',
        remedy: 'give one',
      })
    }
    this.#age = years
  }

  /**
   * Has something done each time before a face is drawn, while `driven` is true.
   *
   * @param areas that it sets, whatever they were set to.
   */
  onDrive(drive: Drive, areas: readonly string[]): void {
    this.#drivers.push(drive)
    this.#driven = new Set([...this.#driven, ...areas])
  }

  /** Whether blendshapes, joints or the like move an area, so that `setActivation` lasts until the next frame only. */
  isDriven(area: string): boolean {
    return this.driven && this.#driven.has(area)
  }

  /** Has something done when these wrinkles are disposed of. */
  onDispose(dispose: () => void): void {
    this.#disposers.push(dispose)
  }

  /** Does what was asked for by `onDispose`; nothing drives the faces any more. */
  dispose(): void {
    for (const dispose of this.#disposers.splice(0)) dispose()
    this.#drivers.length = 0
  }
}
