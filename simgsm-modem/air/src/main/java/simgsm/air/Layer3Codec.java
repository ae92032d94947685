package simgsm.air;

import java.util.List;
import java.util.Optional;
import java.util.random.RandomGenerator;
import simgsm.octets.OctetWriter;

/** Encodes and decodes layer-3 messages (TS 24.008, TS 24.011, TS 24.080, TS 44.018). Has no state. */
public final class Layer3Codec {
    private static final int TYPE_MASK = 0x3f;
    private static final int SEND_SEQUENCE_BIT = 0x40;
    private static final int TI_FLAG = 0x80;
    /** Reserved for extension (TS 24.007, 11.2.3.1.3). */
    private static final int TI_EXTENDED = 7;

    private Layer3Codec() {}

    /**
     * The octets of a message.
     *
     * @param sendSequence N(SD), 0 or 1, set in uplink messages of mobility management, call control and
     *     supplementary services, and ignored in all others (TS 24.007, 11.2.3.2.3)
     * @throws IllegalArgumentException for a message of the other direction
     */
    public static byte[] encode(Layer3Message message, Direction direction, int sendSequence) {
        Layer3Type type = Layer3Type.of(message);
        if (!type.goes(direction)) {
            throw new IllegalArgumentException(type.title() + " never goes " + direction);
        }
        OctetWriter out = new OctetWriter();
        out.octet(transactionOrSkip(message) | type.discriminator());
        boolean sequenced = direction == Direction.UPLINK && hasSendSequence(type.discriminator());
        out.octet(type.code() | (sequenced ? sendSequence << 6 & SEND_SEQUENCE_BIT : 0));
        type.table().write(out, message, direction);
        return out.toArray();
    }

    /**
     * The message in these octets; an uplink message's N(SD) is masked out, see {@link #sendSequence}.
     *
     * @throws ProtocolViolation for a breach of the standard, with the cause for a STATUS answer; see {@code
     *     ProtocolErrorAnswers} for the messages to send
     */
    public static Layer3Message decode(byte[] octets, Direction direction) throws ProtocolViolation {
        MessageReader in = new MessageReader(octets);
        Layer3Header header = readHeader(in, direction);
        try {
            return readBody(header, in);
        } catch (ProtocolViolation violation) {
            throw violation.in(header);
        }
    }

    /** The octets of a message of this direction with random values; not every value can be decoded. */
    public static byte[] random(RandomGenerator random, Direction direction) {
        Layer3Type[] types = Layer3Type.values();
        Layer3Type type = types[random.nextInt(types.length)];
        OctetWriter out = new OctetWriter().octet(type.discriminator()).octet(type.code());
        type.table().writeRandom(out, random, direction);
        return out.toArray();
    }

    /** N(SD) of an uplink message, 0 or 1; -1 for messages without one. */
    public static int sendSequence(byte[] octets) {
        if (octets.length < 2 || !hasSendSequence(octets[0] & 0x0f)) {
            return -1;
        }
        return (octets[1] & SEND_SEQUENCE_BIT) >> 6;
    }

    private static boolean hasSendSequence(int discriminator) {
        return discriminator == Layer3Header.CALL_CONTROL
                || discriminator == Layer3Header.MOBILITY_MANAGEMENT
                || discriminator == Layer3Header.SUPPLEMENTARY_SERVICES;
    }

    private static int transactionOrSkip(Layer3Message message) {
        return message instanceof Layer3Message.OfTransaction part ? nibble(part.transaction()) : 0;
    }

    private static int nibble(TransactionIdentifier transaction) {
        return (transaction.fromOtherSide() ? TI_FLAG : 0) | transaction.value() << 4;
    }

    private static Layer3Header readHeader(MessageReader in, Direction direction) throws ProtocolViolation {
        if (in.remaining() < 2) {
            throw new ProtocolViolation(Cause.PROTOCOL_ERROR, "a message too short to hold a message type");
        }
        int first = in.octet("protocol discriminator");
        int type = in.octet("message type");
        int discriminator = first & 0x0f;
        return switch (discriminator) {
            case Layer3Header.CALL_CONTROL, Layer3Header.SUPPLEMENTARY_SERVICES ->
                header(discriminator, direction, transaction(first), type & TYPE_MASK);
            case Layer3Header.MOBILITY_MANAGEMENT ->
                header(discriminator, direction, skipIndicator(first), type & TYPE_MASK);
            case Layer3Header.RADIO_RESOURCE -> header(discriminator, direction, skipIndicator(first), type);
            case Layer3Header.SHORT_MESSAGES -> header(discriminator, direction, transaction(first), type);
            default ->
                throw new ProtocolViolation(
                        Cause.MESSAGE_TYPE_NON_EXISTENT, "protocol discriminator " + discriminator + " is not known");
        };
    }

    private static Layer3Header header(
            int discriminator, Direction direction, Optional<TransactionIdentifier> transaction, int type) {
        return new Layer3Header(discriminator, direction, transaction, type, Optional.empty());
    }

    private static Optional<TransactionIdentifier> transaction(int first) throws ProtocolViolation {
        int value = first >> 4 & 0x07;
        if (value == TI_EXTENDED) {
            throw new ProtocolViolation(
                    Cause.INVALID_TRANSACTION_IDENTIFIER, "transaction identifier 7 is reserved for extension");
        }
        return Optional.of(new TransactionIdentifier(value, (first & TI_FLAG) != 0));
    }

    /** A message with another skip indicator is to be ignored (TS 24.007, 11.2.3.1.2). */
    private static Optional<TransactionIdentifier> skipIndicator(int first) throws ProtocolViolation {
        if (first >> 4 != 0) {
            throw new ProtocolViolation(
                    Cause.PROTOCOL_ERROR, "skip indicator " + (first >> 4) + " where 0 was expected");
        }
        return Optional.empty();
    }

    private static Layer3Message readBody(Layer3Header header, MessageReader in) throws ProtocolViolation {
        Layer3Type type = header.type()
                .orElseThrow(() ->
                        new ProtocolViolation(Cause.MESSAGE_TYPE_NON_EXISTENT, "not known " + header.direction()));
        try {
            Object[] head = header.transaction().stream().toArray();
            return (Layer3Message) type.table().read(in, header.direction(), head);
        } catch (ProtocolViolation violation) {
            return clearing(type, header).orElseThrow(() -> violation);
        }
    }

    /** A message that clears the call does so even if its elements cannot be read, with cause 96 (TS 24.008, 8.5.2 to 8.5.4). */
    private static Optional<Layer3Message> clearing(Layer3Type type, Layer3Header header) {
        Cause cause = Cause.INVALID_MANDATORY_INFORMATION;
        return header.transaction().map(transaction -> switch (type) {
            case DISCONNECT -> new CallControl.Disconnect(transaction, cause);
            case RELEASE -> new CallControl.Release(transaction, Optional.of(cause));
            case RELEASE_COMPLETE -> new CallControl.ReleaseComplete(transaction, Optional.of(cause));
            default -> null;
        });
    }

    /**
     * The elements in the octets of a message read by {@link #decode}, in order; those of an RP message follow its
     * CP-DATA's.
     */
    public static List<ElementTable.Part> split(byte[] octets, Direction direction) throws ProtocolViolation {
        MessageReader in = new MessageReader(octets);
        Layer3Type type = readHeader(in, direction).type().orElseThrow();
        List<ElementTable.Part> parts = type.table().split(in, direction);
        return type == Layer3Type.CP_DATA ? RelayType.split(parts.get(0).value(), direction) : parts;
    }
}
