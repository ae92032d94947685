package simgsm.web;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;

/** Frames of RFC 6455, 5: decodes the client's from a stream of octets, encodes the server's. */
final class WebSocketFrames {
    static final int CONTINUATION = 0;
    static final int TEXT = 1;
    static final int BINARY = 2;
    static final int CLOSE = 8;
    static final int PING = 9;
    static final int PONG = 10;

    /** No code in a close frame (7.4.1). */
    static final int NO_CODE = 1005;

    private static final int MOST_CONTROL_OCTETS = 125;
    private static final int TWO_OCTETS = 126;
    private static final int EIGHT_OCTETS = 127;
    private static final int FIN = 0x80;
    private static final int RESERVED = 0x70;
    private static final int OPCODE = 0x0f;
    private static final int MASKED = 0x80;
    private static final int LENGTH = 0x7f;
    private static final int MASK_OCTETS = 4;

    /** Receives the client's frames. */
    interface Receiver {
        void text(String text);

        void binary(byte[] octets);

        void ping(byte[] octets);

        /** @param code {@link #NO_CODE} if the frame has none */
        void close(int code);
    }

    private final Receiver receiver;
    private final int mostOctets;
    private final ByteArrayOutputStream message = new ByteArrayOutputStream();
    private ByteBuffer pending = ByteBuffer.allocate(0);
    /** TEXT or BINARY while a fragmented message is incomplete, else CONTINUATION. */
    private int begun = CONTINUATION;

    private boolean isClosed;

    /** @param mostOctets of a message */
    WebSocketFrames(int mostOctets, Receiver receiver) {
        this.mostOctets = mostOctets;
        this.receiver = receiver;
    }

    /** Takes all octets of the buffer; after a close frame they are dropped. */
    void accept(ByteBuffer octets) throws WebSocketViolation {
        ByteBuffer joined = ByteBuffer.allocate(pending.remaining() + octets.remaining());
        pending = joined.put(pending).put(octets).flip();
        boolean isWhole = true;
        while (isWhole && !isClosed) {
            isWhole = takesFrame();
        }
    }

    /** Takes the next frame if it is complete. */
    private boolean takesFrame() throws WebSocketViolation {
        if (pending.remaining() < 2) {
            return false;
        }
        int first = pending.get(pending.position()) & 0xff;
        int second = pending.get(pending.position() + 1) & 0xff;
        checkHead(first, second);
        int shortLength = second & LENGTH;
        int lengthOctets = shortLength == EIGHT_OCTETS ? 8 : shortLength == TWO_OCTETS ? 2 : 0;
        if (pending.remaining() < 2 + lengthOctets) {
            return false;
        }
        long length = lengthOctets == 8
                ? pending.getLong(pending.position() + 2)
                : lengthOctets == 2 ? pending.getShort(pending.position() + 2) & 0xffff : shortLength;
        if (length < 0 || length + ((first & OPCODE) < CLOSE ? message.size() : 0) > mostOctets) {
            throw new WebSocketViolation(
                    WebSocketViolation.TOO_BIG, "message too big, expected at most " + mostOctets + " octets");
        }
        if (pending.remaining() < 2 + lengthOctets + MASK_OCTETS + length) {
            return false;
        }
        pending.position(pending.position() + 2 + lengthOctets);
        byte[] mask = new byte[MASK_OCTETS];
        pending.get(mask);
        byte[] payload = new byte[(int) length];
        pending.get(payload);
        for (int i = 0; i < payload.length; i++) {
            payload[i] ^= mask[i % MASK_OCTETS];
        }
        take(first & OPCODE, (first & FIN) != 0, payload);
        return true;
    }

    private void checkHead(int first, int second) throws WebSocketViolation {
        int opcode = first & OPCODE;
        boolean isControl = opcode >= CLOSE;
        if ((first & RESERVED) != 0) {
            throw broken("a reserved bit is set");
        }
        if ((second & MASKED) == 0) {
            throw broken("a frame without mask");
        }
        if (opcode > BINARY && opcode < CLOSE || opcode > PONG) {
            throw broken("unknown opcode " + opcode);
        }
        if (isControl && ((first & FIN) == 0 || (second & LENGTH) > MOST_CONTROL_OCTETS)) {
            throw broken("a control frame in fragments or of more than " + MOST_CONTROL_OCTETS + " octets");
        }
        if (!isControl && (opcode == CONTINUATION) == (begun == CONTINUATION)) {
            throw broken(
                    opcode == CONTINUATION ? "a continuation of nothing" : "a new message inside a fragmented one");
        }
    }

    private void take(int opcode, boolean isLast, byte[] payload) throws WebSocketViolation {
        switch (opcode) {
            case CLOSE -> close(payload);
            case PING -> receiver.ping(payload);
            case PONG -> {}
            default -> {
                begun = opcode == CONTINUATION ? begun : opcode;
                message.writeBytes(payload);
                if (isLast) {
                    endMessage();
                }
            }
        }
    }

    private void endMessage() throws WebSocketViolation {
        byte[] octets = message.toByteArray();
        boolean isText = begun == TEXT;
        message.reset();
        begun = CONTINUATION;
        if (isText) {
            receiver.text(text(ByteBuffer.wrap(octets)));
        } else {
            receiver.binary(octets);
        }
    }

    private void close(byte[] payload) throws WebSocketViolation {
        int code = payload.length == 0
                ? NO_CODE
                : payload.length == 1 ? 0 : ByteBuffer.wrap(payload).getShort() & 0xffff;
        boolean isOfStandard = code >= 1000 && code <= 1003 || code >= 1007 && code <= 1014;
        if (payload.length > 0 && !isOfStandard && (code < 3000 || code > 4999)) {
            throw broken("close code " + code);
        }
        if (payload.length > 2) {
            text(ByteBuffer.wrap(payload, 2, payload.length - 2));
        }
        isClosed = true;
        receiver.close(code);
    }

    private static String text(ByteBuffer octets) throws WebSocketViolation {
        try {
            return StandardCharsets.UTF_8.newDecoder().decode(octets).toString();
        } catch (CharacterCodingException e) {
            throw new WebSocketViolation(WebSocketViolation.INVALID_TEXT, "a text that is not UTF-8");
        }
    }

    private static WebSocketViolation broken(String text) {
        return new WebSocketViolation(WebSocketViolation.PROTOCOL_ERROR, text);
    }

    /** A whole message of the server, not masked. */
    static byte[] encode(int opcode, byte[] payload) {
        boolean isShort = payload.length <= MOST_CONTROL_OCTETS;
        boolean isMiddle = payload.length <= 0xffff;
        ByteBuffer frame = ByteBuffer.allocate(2 + (isShort ? 0 : isMiddle ? 2 : 8) + payload.length);
        frame.put((byte) (FIN | opcode));
        if (isShort) {
            frame.put((byte) payload.length);
        } else if (isMiddle) {
            frame.put((byte) TWO_OCTETS).putShort((short) payload.length);
        } else {
            frame.put((byte) EIGHT_OCTETS).putLong(payload.length);
        }
        return frame.put(payload).array();
    }

    /** A close frame. */
    static byte[] close(int code, String reason) {
        byte[] words = reason.getBytes(StandardCharsets.UTF_8);
        return encode(
                CLOSE,
                ByteBuffer.allocate(2 + words.length)
                        .putShort((short) code)
                        .put(words)
                        .array());
    }
}
