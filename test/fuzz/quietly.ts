/** Runs a command and discards its output. */
export async function quietly(run: () => Promise<unknown>): Promise<void> {
  const { write } = process.stdout
  const printed = console.error
  process.stdout.write = () => true
  console.error = () => {}
  try {
    await run()
  } finally {
    process.stdout.write = write
    console.error = printed
  }
}
