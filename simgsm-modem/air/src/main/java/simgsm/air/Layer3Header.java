package simgsm.air;

import java.util.Locale;
import java.util.Optional;

/**
 * The header of a layer-3 message, with the data needed to refuse it.
 *
 * @param discriminator protocol discriminator: 3 call control, 5 mobility management, 6 radio resource, 9 short
 *     messages, 11 supplementary services
 * @param transaction present in call control, short messages and supplementary services
 * @param messageType without the send sequence number
 * @param relayReference RP message reference of a refused RP message inside a valid CP-DATA
 */
public record Layer3Header(
        int discriminator,
        Direction direction,
        Optional<TransactionIdentifier> transaction,
        int messageType,
        Optional<Integer> relayReference) {
    public static final int CALL_CONTROL = 3;
    public static final int MOBILITY_MANAGEMENT = 5;
    public static final int RADIO_RESOURCE = 6;
    public static final int SHORT_MESSAGES = 9;
    public static final int SUPPLEMENTARY_SERVICES = 11;

    /** The message's type; empty if unknown in this direction. */
    public Optional<Layer3Type> type() {
        return Layer3Type.of(discriminator, messageType, direction);
    }

    /** The message's name; its numbers if unknown. */
    public String name() {
        return type().map(Layer3Type::title)
                .orElseGet(() ->
                        String.format(Locale.ROOT, "message type 0x%02x of protocol %d", messageType, discriminator));
    }

    Layer3Header withRelayReference(Integer reference) {
        return new Layer3Header(discriminator, direction, transaction, messageType, Optional.ofNullable(reference));
    }
}
