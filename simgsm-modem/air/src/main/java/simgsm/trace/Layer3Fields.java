package simgsm.trace;

import java.lang.reflect.RecordComponent;
import java.util.List;
import java.util.Optional;
import simgsm.air.Direction;
import simgsm.air.ElementTable.Part;
import simgsm.air.ElementType;
import simgsm.air.MessageReader;
import simgsm.air.ProtocolViolation;
import simgsm.air.RelayMessage;
import simgsm.octets.OctetString;

/** The fields of a layer-3 message: the components of its record in order, then the capabilities of the terminal. */
final class Layer3Fields {
    private final FieldList fields;
    private final Direction direction;
    private final List<Part> parts;

    /** @param parts the elements in the message's octets */
    Layer3Fields(FieldList fields, Direction direction, List<Part> parts) {
        this.fields = fields;
        this.direction = direction;
        this.parts = parts;
    }

    void add(Object message) throws ProtocolViolation {
        for (RecordComponent component : message.getClass().getRecordComponents()) {
            Object value = value(component, message);
            if (value instanceof RelayMessage relay) {
                add(relay);
            } else if (component.getName().equals("transaction")) {
                fields.add("transaction", value, 0, 1);
            } else if (value != null) {
                partOf(component.getName()).ifPresent(part -> add(message, component.getName(), value, part));
            }
        }
        for (Part part : parts) {
            ElementType<?> type = part.row().type();
            MessageReader value = part.value();
            if (type == ElementType.BEARER_CAPABILITY && value.hasMore()) {
                String words = CapabilityTexts.bearer(value, direction, fields.texts());
                fields.add("bearerCapability", words, part.from(), part.to());
            } else if ((type == ElementType.CLASSMARK_1 || type == ElementType.CLASSMARK_2) && value.hasMore()) {
                fields.add("classmark", CapabilityTexts.classmark(value, fields.texts()), part.from(), part.to());
            }
        }
    }

    private void add(Object message, String name, Object value, Part part) {
        int start = part.to() - part.value().remaining();
        if (part.row().type() == ElementType.FACILITY) {
            ComponentText.add(fields, (OctetString) value, start);
        } else if (message instanceof RelayMessage.RpData && name.equals("tpdu")) {
            addTransferUnit((OctetString) value, part, start);
        } else {
            fields.add(name, value, part.from(), part.to());
        }
    }

    private void addTransferUnit(OctetString tpdu, Part part, int start) {
        try {
            TpduText.add(fields, tpdu, direction, start);
        } catch (ProtocolViolation violation) {
            fields.add("tpdu", tpdu, part.from(), part.to());
            fields.add(MessageText.WRONG, violation.getMessage());
        }
    }

    private Optional<Part> partOf(String component) {
        return parts.stream()
                .filter(part -> part.row().components().contains(component))
                .findFirst();
    }

    private static Object value(RecordComponent component, Object message) {
        try {
            Object value = component.getAccessor().invoke(message);
            return value instanceof Optional<?> optional ? optional.orElse(null) : value;
        } catch (ReflectiveOperationException impossible) {
            throw new AssertionError(impossible);
        }
    }
}
