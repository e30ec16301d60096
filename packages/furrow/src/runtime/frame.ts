/** The faces of one mesh, as a frame sees them. A phase reads what the phases before it wrote, and calls none of them. */
export interface FrameMember<Engine> {
  /** Blendshapes, joints, tension and the application's inputs, as numbers. */
  readInputs(engine: Engine | null): void
  evaluateDrivers(): void
  applyActivations(): void
  /**
   * Tells the atlas which influence maps have changed.
   *
   * @returns whether they are wanted at all.
   */
  collectInfluence(engine: Engine): boolean
  /** Draws what is derived from the influence maps. */
  composeNormals(engine: Engine): void
}

/** Draws the influence maps that members collected. */
export interface InfluenceTarget<Engine> {
  draw(engine: Engine): void
}

/** A member's place in the order of frames. */
export interface FrameEntry<Engine> {
  readonly member: FrameMember<Engine>
  /** Frame in which it was drawn last, its phases ran last, and its influence was collected last. */
  seen: number
  updated: number
  collected: number
}

/**
 * Runs the phases of frames: inputs -> drivers -> activations -> influence -> draw, each for all faces before the next. Drawing is the
 * engine's; it calls `begin` before it draws a member, and the first member of a frame starts the phases for all that the
 * frame before has seen. A member that comes into sight later in a frame runs its phases then.
 *
 * @typeParam Engine what draws, e.g. a renderer.
 */
export class Frame<Engine> {
  readonly targets: InfluenceTarget<Engine>[] = []
  readonly #entries: FrameEntry<Engine>[] = []
  readonly #renderCount: (engine: Engine) => number
  /** Members whose phases run, of which the first `#count`: emptying the list would allocate. */
  readonly #due: FrameEntry<Engine>[] = []
  #count = 0
  #number = 0
  #renders = -1

  /** @param renderCount grows with every picture that the engine draws. */
  constructor(renderCount: (engine: Engine) => number) {
    this.#renderCount = renderCount
  }

  add(member: FrameMember<Engine>): FrameEntry<Engine> {
    const entry = { member, seen: -1, updated: -1, collected: -1 }
    this.#entries.push(entry)
    return entry
  }

  remove(entry: FrameEntry<Engine>): void {
    this.#entries.splice(this.#entries.indexOf(entry), 1)
    this.#due.length = 0
  }

  /** Called before a member is drawn. */
  begin(entry: FrameEntry<Engine>, engine: Engine): void {
    this.#count = 0
    if (this.#renderCount(engine) !== this.#renders) this.#startNext()
    if (entry.updated !== this.#number) this.#schedule(entry)
    entry.seen = this.#number
    if (this.#count > 0) this.#run(engine)
    else if (entry.collected !== this.#number) this.#showLate(entry, engine)
    this.#renders = this.#renderCount(engine)
  }

  /** Runs a member's phases by hand, up to the influence where there is an engine to draw it. */
  update(entry: FrameEntry<Engine>, engine: Engine | null): void {
    this.#count = 0
    this.#due[this.#count++] = entry
    this.#run(engine)
  }

  /** The frame, phase by phase. */
  #run(engine: Engine | null): void {
    const due = this.#due
    const count = this.#count
    for (let i = 0; i < count; i++) due[i].member.readInputs(engine)
    for (let i = 0; i < count; i++) due[i].member.evaluateDrivers()
    for (let i = 0; i < count; i++) due[i].member.applyActivations()
    if (engine === null) return
    for (let i = 0; i < count; i++) this.#collect(due[i], engine)
    for (let i = 0; i < this.targets.length; i++) this.targets[i].draw(engine)
    for (let i = 0; i < count; i++) due[i].member.composeNormals(engine)
  }

  #startNext(): void {
    const last = this.#number++
    for (let i = 0; i < this.#entries.length; i++) {
      const entry = this.#entries[i]
      if (entry.seen === last || entry.updated < 0) this.#schedule(entry)
    }
  }

  #schedule(entry: FrameEntry<Engine>): void {
    entry.updated = this.#number
    this.#due[this.#count++] = entry
  }

  #collect(entry: FrameEntry<Engine>, engine: Engine): void {
    if (entry.member.collectInfluence(engine)) entry.collected = this.#number
  }

  /** A member whose influence was not wanted when the frame began. */
  #showLate(entry: FrameEntry<Engine>, engine: Engine): void {
    this.#collect(entry, engine)
    if (entry.collected !== this.#number) return
    for (let i = 0; i < this.targets.length; i++) this.targets[i].draw(engine)
    entry.member.composeNormals(engine)
  }
}
