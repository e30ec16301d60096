/** Faces of one mesh in the frame loop. A phase reads results of earlier phases and never calls them. */
export interface FrameMember<Engine> {
  /** Updates materials and other drawn state; called between frames when another member is added. */
  refresh?(): void
  /** Phase 1: reads blendshapes, joints, tension and the application's inputs. */
  readInputs(engine: Engine | null): void
  /** Phase 2: evaluates drivers. */
  evaluateDrivers(): void
  /** Phase 3: sets the activations of the faces. */
  applyActivations(): void
  /**
   * Phase 4: reports changed influence maps to the atlas.
   *
   * @returns whether the influence maps are used in this frame.
   */
  collectInfluence(engine: Engine): boolean
  /** Phase 5: draws composed normals from the influence maps. */
  composeNormals(engine: Engine): void
}

/** Draws the influence maps collected by members. */
export interface InfluenceTarget<Engine> {
  draw(engine: Engine): void
}

/** A member and its latest frame numbers. */
export interface FrameEntry<Engine> {
  readonly member: FrameMember<Engine>
  /** Whether inputs may change after `beginImage`, so that the phases wait until a member is drawn. */
  isLate: boolean
  /** Frame of the last draw. */
  seen: number
  /** Frame in which the phases last ran. */
  updated: number
  /** Frame in which influence was last collected. */
  collected: number
}

/** Current or latest frame of an engine. */
interface Drawn {
  number: number
  /** Frame whose members are expected again: the last one with a drawn member, of the same scene if known. */
  last: number
  /** Render count at the last draw. */
  renders: number
  /** Whether the image has begun but no member has been drawn. */
  isEarly: boolean
}

/**
 * Runs the phases of frames: inputs -> drivers -> activations -> influence -> draw, each for all faces before the next.
 *
 * The engine calls `begin` before it draws a member. The first call in a frame runs the phases of all members that were drawn in the last
 * frame or never ran; `beginImage` does this before anything is drawn. Members that come into view later run their phases then. Each
 * engine on a page has its own frames.
 *
 * @typeParam Engine object that draws, e.g. a renderer.
 * @typeParam Target destination of influence maps.
 */
export class Frame<Engine extends object, Target extends InfluenceTarget<Engine> = InfluenceTarget<Engine>> {
  readonly targets: Target[] = []
  readonly #entries: FrameEntry<Engine>[] = []
  readonly #renderCount: (engine: Engine) => number
  /** Members whose phases run: the first `#count` items. The array is never emptied, because that would allocate. */
  readonly #due: FrameEntry<Engine>[] = []
  #count = 0
  /** Number of the latest frame of any engine. */
  #number = 0
  readonly #drawn = new WeakMap<Engine, Drawn>()

  /** @param renderCount returns a number that changes with every image of the engine. */
  constructor(renderCount: (engine: Engine) => number) {
    this.#renderCount = renderCount
  }

  /** Adds a member. Pass the returned entry to the other methods. */
  add(member: FrameMember<Engine>): FrameEntry<Engine> {
    for (const other of this.#entries) other.member.refresh?.()
    const entry = { member, isLate: false, seen: -1, updated: -1, collected: -1 }
    this.#entries.push(entry)
    return entry
  }

  /** Removes a member. */
  remove(entry: FrameEntry<Engine>): void {
    this.#entries.splice(this.#entries.indexOf(entry), 1)
    this.#due.length = 0
  }

  /**
   * Runs the phases of expected members. Call before an image is drawn, so that drawing influence does not interrupt it. Other members run
   * their phases when the first member is drawn.
   *
   * @param last frame whose members are expected: that of the last image of the scene.
   * @param isCounted whether the render count already includes the image.
   */
  beginImage(engine: Engine, last: number, isCounted: boolean): void {
    this.#count = 0
    const drawn = this.#drawnBy(engine)
    drawn.number = ++this.#number
    this.#scheduleOf(last, drawn.number, true)
    if (this.#count > 0) this.#run(engine, drawn.number)
    drawn.isEarly = true
    drawn.last = last
    drawn.renders = this.#renderCount(engine) + Number(!isCounted)
  }

  /** Runs phases that are due. Call before a member is drawn. */
  begin(entry: FrameEntry<Engine>, engine: Engine): void {
    this.#count = 0
    const drawn = this.#drawnBy(engine)
    const isNext = this.#renderCount(engine) !== drawn.renders
    if (isNext) drawn.number = ++this.#number
    if (isNext || drawn.isEarly) this.#scheduleOf(drawn.last, drawn.number, false)
    if (entry.updated !== drawn.number) this.#schedule(entry, drawn.number)
    entry.seen = drawn.last = drawn.number
    drawn.isEarly = false
    if (this.#count > 0) this.#run(engine, drawn.number)
    else if (entry.collected !== drawn.number) this.#collectLate(entry, engine, drawn.number)
    drawn.renders = this.#renderCount(engine)
  }

  /** Runs the phases of one member now. Influence is drawn only if an engine is given. */
  update(entry: FrameEntry<Engine>, engine: Engine | null): void {
    this.#count = 0
    this.#due[this.#count++] = entry
    this.#run(engine, engine ? this.#drawnBy(engine).number : this.#number)
  }

  #drawnBy(engine: Engine): Drawn {
    let drawn = this.#drawn.get(engine)
    if (!drawn) {
      drawn = { number: 0, last: 0, renders: -1, isEarly: false }
      this.#drawn.set(engine, drawn)
    }
    return drawn
  }

  /** Runs all phases of the scheduled members. */
  #run(engine: Engine | null, number: number): void {
    const due = this.#due
    const count = this.#count
    for (let i = 0; i < count; i++) due[i].member.readInputs(engine)
    for (let i = 0; i < count; i++) due[i].member.evaluateDrivers()
    for (let i = 0; i < count; i++) due[i].member.applyActivations()
    if (engine === null) return
    for (let i = 0; i < count; i++) this.#collect(due[i], engine, number)
    for (let i = 0; i < this.targets.length; i++) this.targets[i].draw(engine)
    for (let i = 0; i < count; i++) due[i].member.composeNormals(engine)
  }

  /** Schedules members that were drawn in frame `last` or never ran. */
  #scheduleOf(last: number, number: number, isEarly: boolean): void {
    for (let i = 0; i < this.#entries.length; i++) {
      const entry = this.#entries[i]
      if (entry.updated === number || (isEarly && entry.isLate)) continue
      if (entry.seen === last || entry.updated < 0) this.#schedule(entry, number)
    }
  }

  #schedule(entry: FrameEntry<Engine>, number: number): void {
    entry.updated = number
    this.#due[this.#count++] = entry
  }

  #collect(entry: FrameEntry<Engine>, engine: Engine, number: number): void {
    if (entry.member.collectInfluence(engine)) entry.collected = number
  }

  /** Collects and draws influence that was unused when the member's phases ran. */
  #collectLate(entry: FrameEntry<Engine>, engine: Engine, number: number): void {
    this.#collect(entry, engine, number)
    if (entry.collected !== number) return
    for (let i = 0; i < this.targets.length; i++) this.targets[i].draw(engine)
    entry.member.composeNormals(engine)
  }
}
