package simgsm.trace;

import java.lang.reflect.RecordComponent;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import simgsm.air.Coded;
import simgsm.air.LocationArea;
import simgsm.air.MobileIdentity;
import simgsm.air.RelayMessage;
import simgsm.air.TransactionIdentifier;
import simgsm.octets.OctetString;
import simgsm.trace.MessageText.Field;

/** The components of message records as fields in words, by reflection. */
final class FieldTexts {
    private FieldTexts() {}

    /**
     * Adds the components in their order; absent optional ones are left out, the RP message of a CP-DATA and the
     * component of a facility by their parts.
     */
    static void add(List<Field> fields, Object message) {
        for (RecordComponent component : message.getClass().getRecordComponents()) {
            Object value = value(component, message);
            if (value instanceof Optional<?> optional) {
                value = optional.orElse(null);
            }
            if (value instanceof RelayMessage relay) {
                add(fields, relay);
            } else if (component.getName().equals("facility")) {
                if (value != null) {
                    ComponentText.add(fields, (OctetString) value);
                }
            } else if (value != null) {
                fields.add(new Field(spaced(component.getName(), false), text(value)));
            }
        }
    }

    static String text(Object value) {
        if (value instanceof Coded.Titled cause) {
            return cause.code() + " " + cause.title();
        }
        if (value instanceof MobileIdentity identity) {
            return identity.type() + " " + identity;
        }
        if (value instanceof TransactionIdentifier transaction) {
            return transaction.value()
                    + (transaction.fromOtherSide() ? ", opened by the receiver" : ", opened by the sender");
        }
        if (value instanceof LocationArea area) {
            return area.countryCode() + "/" + area.networkCode() + " area " + area.areaCode();
        }
        return value instanceof Enum<?> name
                ? name.name().replace('_', ' ').toLowerCase(Locale.ROOT)
                : value.toString();
    }

    /** Words of a name in camel case: "keySequence" as "key sequence", "DataRequest" as "Data Request". */
    static String spaced(String name, boolean capitals) {
        String words = name.replaceAll("(?<=[a-z])(?=[A-Z])", " ");
        return capitals ? words : words.toLowerCase(Locale.ROOT);
    }

    private static Object value(RecordComponent component, Object message) {
        try {
            return component.getAccessor().invoke(message);
        } catch (ReflectiveOperationException impossible) {
            throw new AssertionError(impossible);
        }
    }
}
