/** The faces of one mesh, which take part in frames. A phase reads what earlier phases wrote, and never calls one. */
export interface FrameMember<Engine> {
  /** Called between frames when another member joins: brings what the member is drawn with up to date. */
  refresh?(): void
  /** Phase 1: reads blendshapes, joints, tension and the application's inputs. */
  readInputs(engine: Engine | null): void
  /** Phase 2: from inputs to the drivers' activations. */
  evaluateDrivers(): void
  /** Phase 3: sets the activations of the faces. */
  applyActivations(): void
  /**
   * Phase 4: tells the atlas which influence maps have changed.
   *
   * @returns whether they are used at all in this frame.
   */
  collectInfluence(engine: Engine): boolean
  /** Phase 5: draws what is derived from the influence maps. */
  composeNormals(engine: Engine): void
}

/** Draws the influence maps that members collected. */
export interface InfluenceTarget<Engine> {
  draw(engine: Engine): void
}

/** A member, and the numbers of the frames that it last took part in. */
export interface FrameEntry<Engine> {
  readonly member: FrameMember<Engine>
  /** Whether what it reads may change after an image has begun, so that its phases wait until a member is drawn. */
  isLate: boolean
  /** In which it was drawn. */
  seen: number
  /** In which its phases ran. */
  updated: number
  /** In which its influence was collected. */
  collected: number
}

/** The frame that an engine draws, or drew last. */
interface Drawn {
  number: number
  /** The one of which members are expected: the last in which one was drawn, of the same scene where that is known. */
  last: number
  /** What its images were counted by when a member was last drawn. */
  renders: number
  /** Whether its image has begun, and no member has been drawn in it. */
  isEarly: boolean
}

/**
 * Runs the phases of frames: inputs -> drivers -> activations -> influence -> draw, each for all faces before the next. The engine
 * draws, and calls `begin` before it draws a member: the first one in a frame runs the phases of all members that were drawn in the
 * frame before, or never ran; `beginImage` does so before anything is drawn. A member that comes into view later in a frame runs its
 * phases then. Where several engines draw on one page, each has frames of its own: what one draws is not there for another.
 *
 * @typeParam Engine what draws, e.g. a renderer.
 * @typeParam Target what it draws influence maps into.
 */
export class Frame<Engine extends object, Target extends InfluenceTarget<Engine> = InfluenceTarget<Engine>> {
  readonly targets: Target[] = []
  readonly #entries: FrameEntry<Engine>[] = []
  readonly #renderCount: (engine: Engine) => number
  /** The members whose phases run are the first `#count` of these: emptying the list would allocate. */
  readonly #due: FrameEntry<Engine>[] = []
  #count = 0
  /** Of the frame that began last, whichever engine draws it. */
  #number = 0
  readonly #drawn = new WeakMap<Engine, Drawn>()

  /** @param renderCount a number that changes with every image that the engine draws. */
  constructor(renderCount: (engine: Engine) => number) {
    this.#renderCount = renderCount
  }

  /** Adds a member; the entry is for the methods below. */
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
   * To be called before an image is drawn in which members may be: what draws influence then interrupts nothing. Those that are not among them
   * run their phases when the first member is drawn.
   *
   * @param last the frame of which members are expected: that of the last image of the same scene.
   * @param isCounted whether the engine has counted the image already.
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

  /** To be called before a member is drawn. */
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

  /** Runs the phases of one member now; influence is drawn only with an engine. */
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

  /** The frame, phase by phase. */
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

  /** Those that were drawn in a frame, or never ran. */
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

  /** For a member whose influence was not used when its phases ran, but is now. */
  #collectLate(entry: FrameEntry<Engine>, engine: Engine, number: number): void {
    this.#collect(entry, engine, number)
    if (entry.collected !== number) return
    for (let i = 0; i < this.targets.length; i++) this.targets[i].draw(engine)
    entry.member.composeNormals(engine)
  }
}
