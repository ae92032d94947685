package simgsm.center.msc;

import java.util.Locale;
import simgsm.air.Layer3Message;
import simgsm.air.Layer3Type;
import simgsm.air.RelayMessage;
import simgsm.air.ShortMessageControl;

/** What messages are called on the ladder. */
final class MessageNames {
    private static final ClassValue<String> RELAY_NAMES = new ClassValue<>() {
        @Override
        protected String computeValue(Class<?> type) {
            return "RP-" + type.getSimpleName().substring(2).toUpperCase(Locale.ROOT);
        }
    };

    private MessageNames() {}

    /** As SETUP, LOCATION UPDATING REQUEST, or CP-DATA (RP-ACK). */
    static String of(Layer3Message message) {
        String name = Layer3Type.of(message).title();
        return message instanceof ShortMessageControl.CpData data ? name + " (" + of(data.relay()) + ")" : name;
    }

    private static String of(RelayMessage message) {
        return RELAY_NAMES.get(message.getClass());
    }
}
