// The engine's messages in the words of the page, which counts loops from 1.

/** `drawn`: the number that the engine gives to the loop that is being drawn. */
export function forPeople(message: string, drawn: number | null = null): string {
  return message.replace(/\bloop (\d+)/g, (_, number: string) =>
    Number(number) === drawn ? 'this loop' : `loop ${Number(number) + 1}`,
  );
}
