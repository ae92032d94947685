package simgsm.center.msc;

import java.util.Locale;
import simgsm.air.Layer3Message;
import simgsm.air.ShortMessageControl;

/** The standard's names of messages, made from the records' names. */
final class MessageNames {
    private static final ClassValue<String> NAMES = new ClassValue<>() {
        @Override
        protected String computeValue(Class<?> type) {
            return type.getSimpleName()
                    .replaceAll("(?<=[a-z])(?=[A-Z])", " ")
                    .toUpperCase(Locale.ROOT)
                    .replace("CP ", "CP-")
                    .replace("RP ", "RP-");
        }
    };

    private MessageNames() {}

    /** As SETUP, LOCATION UPDATING REQUEST, or CP-DATA (RP-ACK). */
    static String of(Layer3Message message) {
        String name = NAMES.get(message.getClass());
        return message instanceof ShortMessageControl.CpData data
                ? name + " (" + NAMES.get(data.relay().getClass()) + ")"
                : name;
    }
}
