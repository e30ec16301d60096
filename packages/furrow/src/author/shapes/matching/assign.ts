/**
 * Assigns each row of a cost matrix a distinct column so that the total cost is minimal (Kuhn 1955; shortest augmenting paths: Jonker and
 * Volgenant 1987).
 *
 * @param cost matrix by row, with at least as many columns as rows.
 * @returns column of each row.
 */
export function assign(cost: readonly Float64Array[]): number[] {
  const [rows, columns] = [cost.length, cost[0]?.length ?? 0]
  const rowPrice = new Float64Array(rows + 1)
  const columnPrice = new Float64Array(columns + 1)
  /** Row assigned to each column; rows and columns are counted from 1, and row 0 means none. */
  const rowOf = new Int32Array(columns + 1)
  const before = new Int32Array(columns + 1)
  for (let row = 1; row <= rows; row++) {
    rowOf[0] = row
    let column = 0
    const least = new Float64Array(columns + 1).fill(Infinity)
    const isUsed = new Uint8Array(columns + 1)
    do {
      isUsed[column] = 1
      const from = rowOf[column]
      let [step, next] = [Infinity, 0]
      for (let j = 1; j <= columns; j++) {
        if (isUsed[j]) continue
        const reduced = cost[from - 1][j - 1] - rowPrice[from] - columnPrice[j]
        if (reduced < least[j]) {
          least[j] = reduced
          before[j] = column
        }
        if (least[j] < step) {
          step = least[j]
          next = j
        }
      }
      for (let j = 0; j <= columns; j++) {
        if (isUsed[j]) {
          rowPrice[rowOf[j]] += step
          columnPrice[j] -= step
        } else least[j] -= step
      }
      column = next
    } while (rowOf[column] !== 0)
    do {
      rowOf[column] = rowOf[before[column]]
      column = before[column]
    } while (column !== 0)
  }
  const out = new Array<number>(rows).fill(-1)
  for (let j = 1; j <= columns; j++) if (rowOf[j] > 0) out[rowOf[j] - 1] = j - 1
  return out
}
