/** A member of the frame loop: the faces of one mesh. Each method runs one phase, and never calls an earlier phase. */
export interface FrameMember<Engine> {
  /** Updates materials and other state for drawing. Called between frames, when another member is added. */
  refresh?(): void
  /** Phase 1: reads blendshapes, joints, tension and the application's inputs. */
  readInputs(engine: Engine | null): void
  /** Phase 2: evaluates drivers. */
  evaluateDrivers(): void
  /** Phase 3: sets the activations of the faces. */
  applyActivations(): void
  /**
   * Phase 4: tells the atlas which influence maps have changed.
   *
   * @returns whether this frame uses the member's influence maps.
   */
  collectInfluence(engine: Engine): boolean
  /** Phase 5: draws normal maps that include the wrinkles, if the member is in mode `composed`. */
  composeNormals(engine: Engine): void
}

/** Texture into which the influence maps of members are drawn. */
export interface InfluenceTarget<Engine> {
  draw(engine: Engine): void
}

/** A member, and the numbers of the frames in which it was last updated. */
export interface FrameEntry<Engine> {
  readonly member: FrameMember<Engine>
  /** Whether inputs may change after `beginImage`. If so, the phases run when the first member is drawn. */
  isLate: boolean
  /** Frame in which the member was last drawn. */
  seen: number
  /** Frame in which the phases last ran. */
  updated: number
  /** Frame in which `collectInfluence` last returned true. */
  collected: number
}

/** The latest frame of one engine. */
interface Drawn {
  number: number
  /** Number of an earlier frame. Members that were drawn in it are expected to be drawn again. */
  last: number
  /** Render count of the engine when a member was last drawn. */
  renders: number
  /** Whether `beginImage` has run but no member has been drawn since. */
  isEarly: boolean
}

/**
 * Runs the phases of each frame: reading inputs, evaluating drivers, applying activations, drawing influence maps, composing normals.
 * Each phase finishes for all members before the next phase begins. A member is the set of faces of one mesh. An influence map stores how
 * visible each wrinkle layer is at each point of the skin.
 *
 * The engine calls `begin` before it draws a member. The first call in a frame runs the phases of all members that were drawn in the
 * previous frame, and of new members. The phases of other members run when these members are drawn. An engine may call `beginImage` to
 * run the phases before anything is drawn. Each engine (renderer) of a page has its own frames.
 *
 * @typeParam Engine object that draws, e.g. a renderer.
 * @typeParam Target texture into which influence maps are drawn.
 */
export class Frame<Engine extends object, Target extends InfluenceTarget<Engine> = InfluenceTarget<Engine>> {
  readonly targets: Target[] = []
  readonly #entries: FrameEntry<Engine>[] = []
  readonly #renderCount: (engine: Engine) => number
  /** The phases of the first `#count` items run. The array is not emptied after a frame, because filling it again would allocate. */
  readonly #due: FrameEntry<Engine>[] = []
  #count = 0
  /** Number of the latest frame, counted over all engines. */
  #number = 0
  readonly #drawn = new WeakMap<Engine, Drawn>()

  /** @param renderCount returns a number that changes with every image that the engine draws. */
  constructor(renderCount: (engine: Engine) => number) {
    this.#renderCount = renderCount
  }

  /** Adds a member. The returned entry is an argument of the other methods. */
  add(member: FrameMember<Engine>): FrameEntry<Engine> {
    for (const other of this.#entries) other.member.refresh?.()
    const entry = { member, isLate: false, seen: -1, updated: -1, collected: -1 }
    this.#entries.push(entry)
    return entry
  }

  remove(entry: FrameEntry<Engine>): void {
    this.#entries.splice(this.#entries.indexOf(entry), 1)
    this.#due.length = 0
  }

  /**
   * Runs the phases of all members that were drawn in frame `last`, and of new members. Call this method before the engine draws an
   * image, so that influence maps are not drawn in the middle of the image.
   *
   * @param last number of the frame in which the scene was last drawn.
   * @param isCounted whether the render count already includes the new image.
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

  /**
   * Prepares a member. Call this method before the engine draws the member. The first call in a frame runs the phases of all members that are
   * due. Later calls run the phases of this member if they have not run in this frame.
   */
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

  /** Runs the phases of one member now. Influence maps and normals are drawn only if an engine is given. */
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

  /** Schedules members that were drawn in frame `last`, and new members. */
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

  /** Draws the member's influence maps if they are used now, but were not used when the member's phases ran. */
  #collectLate(entry: FrameEntry<Engine>, engine: Engine, number: number): void {
    this.#collect(entry, engine, number)
    if (entry.collected !== number) return
    for (let i = 0; i < this.targets.length; i++) this.targets[i].draw(engine)
    entry.member.composeNormals(engine)
  }
}
