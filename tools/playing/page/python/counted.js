// fetch, with each piece that arrives told of: loading Python takes a while.

export function countFetched(tell) {
  const plain = self.fetch;
  self.fetch = async (...request) => {
    const answer = await plain(...request);
    if (!answer.body) return answer;
    const counting = new TransformStream({
      transform(piece, out) {
        tell(piece.length);
        out.enqueue(piece);
      },
    });
    const { status, statusText, headers } = answer;
    return new Response(answer.body.pipeThrough(counting), { status, statusText, headers });
  };
}
