package simgsm.web;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;
import simgsm.net.OutputQueue;
import simgsm.net.QueuedConnection;

/** A client's connection: the head of its first request selects a WebSocket or the pages. */
final class DoorConnection extends QueuedConnection implements WebSocketSession.Carrier {
    private static final int MOST_HEAD_OCTETS = 16 * 1024;
    private static final int HEAD_TOO_LARGE = 431;
    private static final long HEAD_NANOS = TimeUnit.SECONDS.toNanos(3);
    /** Time of a client to answer a close frame by its own (RFC 6455, 7.1.1). */
    private static final long CLOSE_NANOS = TimeUnit.SECONDS.toNanos(1);

    /** Time of the answer to a client that has ended its side of the connection. */
    private static final long ANSWER_NANOS = TimeUnit.SECONDS.toNanos(10);

    private static final long TAKE_NANOS = TimeUnit.SECONDS.toNanos(10);
    private static final String NOT_READING = "the client does not read";

    private static final int MOST_MESSAGES = 1_000;
    private static final int MOST_DROPPABLE = 10;

    private final WebDoor door;
    private final Endpoint endpoint;
    private final StringBuilder head = new StringBuilder();
    /** Null until the head has been read, and for a passed connection. */
    private WebSocketSession socket;
    /** Null unless the connection is passed on. */
    private PassedConnection passed;

    private boolean isEnding;
    private boolean isInputEnded;

    DoorConnection(Endpoint endpoint, WebDoor door) {
        super(endpoint, new OutputQueue(MOST_MESSAGES, MOST_DROPPABLE, written -> {}));
        this.endpoint = endpoint;
        this.door = door;
    }

    @Override
    protected void opened() {
        after(HEAD_NANOS, () -> {
            if (socket == null && passed == null) {
                fail("no complete request within 3 s");
            }
        });
    }

    @Override
    protected void received(ByteBuffer octets) {
        if (socket != null) {
            socket.received(octets);
        } else if (passed != null) {
            passed.fromClient(octets);
        } else if (!isEnding) {
            receiveHead(octets);
        }
    }

    private void receiveHead(ByteBuffer octets) {
        int before = head.length();
        head.append(StandardCharsets.ISO_8859_1.decode(octets));
        int end = head.indexOf("\r\n\r\n", Math.max(0, before - 3));
        try {
            if (end >= 0) {
                begin(HttpHead.parse(head.substring(0, end)), end + 4);
            } else if (head.length() > MOST_HEAD_OCTETS) {
                throw new RequestException(
                        HEAD_TOO_LARGE, "the head of the request has over " + MOST_HEAD_OCTETS + " octets");
            }
        } catch (RequestException refusal) {
            end(WebSocketHandshake.refusal(refusal));
        }
    }

    private void begin(HttpHead asked, int end) throws RequestException {
        if (!WebSocketHandshake.isAsked(asked)) {
            passed = new PassedConnection(endpoint.loop(), this, door);
            passed.fromClient(rest(0));
            return;
        }
        WebSocketPath path = door.path(asked);
        send(WebSocketHandshake.answer(asked, path), false);
        socket = new WebSocketSession(path, this, Origins.isLocal(asked.field("Origin")));
        socket.received(rest(end));
    }

    private ByteBuffer rest(int from) {
        return ByteBuffer.wrap(head.substring(from).getBytes(StandardCharsets.ISO_8859_1));
    }

    @Override
    public void send(byte[] octets, boolean isDroppable) {
        if (!isOpen()) {
            return;
        }
        if (!hasOutput()) {
            expectProgress();
        }
        if (!writeLater(octets, isDroppable)) {
            fail(NOT_READING);
        }
    }

    /** Ends the connection if its client takes no whole message in this time. */
    private void expectProgress() {
        long before = output().taken();
        after(TAKE_NANOS, () -> {
            if (hasOutput() && output().taken() == before) {
                fail(NOT_READING);
            } else if (hasOutput()) {
                expectProgress();
            }
        });
    }

    @Override
    public void end(byte[] last) {
        isEnding = true;
        send(last, false);
        after(CLOSE_NANOS, () -> fail("ended"));
    }

    @Override
    public void later(long nanos, Runnable action) {
        after(nanos, action);
    }

    @Override
    public InetAddress peer() {
        return address().getAddress();
    }

    /** Stops and resumes reading from the client. */
    void setReading(boolean isReading) {
        if (isReading && !isInputEnded) {
            resumeReading();
        } else {
            pauseReading();
        }
    }

    @Override
    protected boolean outlivesInput() {
        isInputEnded = true;
        after(ANSWER_NANOS, () -> fail("the client has ended its side"));
        return passed != null;
    }

    @Override
    protected void writeTo(WritableByteChannel channel) throws IOException {
        super.writeTo(channel);
        if (passed != null && !hasOutput()) {
            passed.clientHasTakenAll();
        }
    }

    @Override
    protected void closing(boolean isByPeer) {
        if (socket != null) {
            socket.ended();
        } else if (passed != null) {
            passed.clientEnded();
        }
    }
}
