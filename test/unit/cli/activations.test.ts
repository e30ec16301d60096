import { describe, expect, it } from 'vitest'
import { bench } from './workshop.ts'

const human = 'faces/human.glb'
const shop = bench('activations')

describe('furrow activations', () => {
  it('prints the activation of each area, and what contributes to it', async () => {
    await shop.run(human, '--set', 'mouthSmileLeft=1', 'cheekSquintLeft=0.5')
    const lines = shop.printed.split('\n')
    // The links add up to 0.8 * 0.5 + 0.3 * 1 = 0.7. The curve runs from (0.25, 0) to (0.9, 1).
    const at = lines.indexOf('0.692  crowsFeetLeft')
    expect(at).toBeGreaterThanOrEqual(0)
    expect(lines[at + 1]).toMatch(
      /^ {2}0\.692 {2}crowsFeetLeft = 0\.8 cheekSquintLeft \+ 0\.3 mouthSmileLeft/,
    )
    expect(lines[at + 2]).toBe('        0.400  0.8 cheekSquintLeft')
    expect(lines[at + 3]).toBe('        0.300  0.3 mouthSmileLeft')
    expect(lines).toContain('0.000  crowsFeetRight')
    expect(lines).toContain('1.000  nasolabialLeft')
  })

  it('prints activations as JSON, for an expression and further blendshapes', async () => {
    await shop.run(human, '--expression', 'angry', '--set', 'noseSneer_L=0', '--json')
    const { file, areas } = JSON.parse(shop.printed)
    expect(file).toBe(human)
    const of = (name: string) => areas.find(({ area }: { area: string }) => area === name)
    // The links of both brows add up to 1, beyond the end of the curve at 0.9.
    expect(of('glabella').activation).toBe(1)
    // Only the right link has a value, 0.5 * 0.35. The curve runs from (0.05, 0) to (0.8, 1).
    expect(of('nose').activation).toBeCloseTo((0.175 - 0.05) / 0.75, 6)
    expect(of('nose').parts[0].links).toContainEqual({
      link: { name: 'noseSneerRight', weight: 0.5 },
      value: expect.closeTo(0.175, 9),
    })
  })

  it('refuses a blendshape that the face lacks', async () => {
    await shop.fails('unknown blendshape, got "trunkUp"', human, '--set', 'trunkUp=1')
  })
})
