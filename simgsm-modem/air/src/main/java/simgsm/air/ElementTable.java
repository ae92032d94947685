package simgsm.air;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.random.RandomGenerator;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/**
 * The information elements of one message, bound to the components of its record; encodes and decodes them (TS
 * 24.007, 11.2). Elements without identifier are read first, then the others:
 * <pre>
 *   1xxx....   one octet, value inside          skipped when unknown
 *   0000xxxx   identifier, length, value        refused when unknown: it must be understood
 *   0xxxxxxx   identifier, length, value        skipped when unknown
 * </pre>
 * An optional element that is truncated or cannot be read counts as absent (TS 24.008, 8.7.1); of two the first is
 * taken.
 */
public final class ElementTable {
    /** An element in the octets of a message. @param from index of its first octet; @param to index after its last one */
    public record Part(Element row, MessageReader value, int from, int to) {}

    private final Map<Direction, List<Element>> rows = new EnumMap<>(Direction.class);
    private final MethodHandle constructor;
    private final MethodHandle[] accessors;
    private final Object[] absent;

    /** @throws IllegalArgumentException for a row with an unknown component of the record */
    ElementTable(Class<?> message, List<Element> elements) {
        RecordComponent[] parts = message.getRecordComponents();
        Class<?>[] types = Arrays.stream(parts).map(RecordComponent::getType).toArray(Class[]::new);
        List<String> components =
                Arrays.stream(parts).map(RecordComponent::getName).toList();
        absent = new Object[parts.length];
        accessors = new MethodHandle[parts.length];
        try {
            MethodHandles.Lookup lookup = MethodHandles.lookup();
            constructor = lookup.findConstructor(message, MethodType.methodType(void.class, types))
                    .asSpreader(Object[].class, parts.length)
                    .asType(MethodType.methodType(Object.class, Object[].class));
            for (int i = 0; i < parts.length; i++) {
                accessors[i] = lookup.unreflect(parts[i].getAccessor())
                        .asType(MethodType.methodType(Object.class, Object.class));
                absent[i] = types[i] == Optional.class ? Optional.empty() : types[i] == boolean.class ? false : null;
            }
        } catch (ReflectiveOperationException impossible) {
            throw new AssertionError(impossible);
        }
        for (Element row : elements) {
            row.places = row.components().stream().mapToInt(components::indexOf).toArray();
            for (int place : row.places) {
                if (place < 0) {
                    throw new IllegalArgumentException(row.components() + " are not components of " + message);
                }
                absent[place] = row.absent == null ? absent[place] : row.absent;
            }
        }
        for (Direction direction : Direction.values()) {
            rows.put(
                    direction,
                    elements.stream().filter(row -> row.isIn(direction)).toList());
        }
    }

    /** The rows of messages in this direction. */
    List<Element> rows(Direction direction) {
        return rows.get(direction);
    }

    void write(OctetWriter out, Object message, Direction direction) {
        boolean isSecondHalf = false;
        for (Element row : rows.get(direction)) {
            write(out, row, message, direction);
            boolean isHalf = row.format == Element.Format.HALF;
            if (isHalf && isSecondHalf) {
                out.joinHalves();
            }
            isSecondHalf = isHalf && !isSecondHalf;
        }
    }

    @SuppressWarnings("unchecked")
    private void write(OctetWriter out, Element row, Object message, Direction direction) {
        Object value = row.places.length == 0 ? row.sent : value(row, message);
        if (value == null) {
            return;
        }
        if (row.format.hasIdentifier()) {
            out.octet(row.identifier);
        }
        int start = row.format.hasLength() ? out.openLength() : out.length();
        if (row.places.length == 0) {
            out.string((OctetString) value);
        } else {
            ((ElementType<Object>) row.type()).write(out, value, direction);
        }
        int length = out.length() - start;
        if (row.format != Element.Format.HALF && !row.allows(length)) {
            throw new IllegalArgumentException(row.type().title() + " of " + length + " octets");
        }
        if (row.format.hasLength()) {
            out.closeLength(start);
        }
    }

    /** The value of the row's component, or the array of its components' values; null for an absent element. */
    private Object value(Element row, Object message) {
        Object[] values = new Object[row.places.length];
        for (int i = 0; i < values.length; i++) {
            Object value = component(message, row.places[i]);
            values[i] = value instanceof Optional<?> optional ? optional.orElse(null) : value;
            if (values[i] == null || values[i] == Boolean.FALSE) {
                return null;
            }
        }
        return values.length == 1 ? values[0] : values;
    }

    private Object component(Object message, int index) {
        try {
            return (Object) accessors[index].invokeExact(message);
        } catch (Throwable impossible) {
            throw new AssertionError(impossible);
        }
    }

    /** Writes the mandatory elements and some of the others, all with random lengths and values. */
    void writeRandom(OctetWriter out, RandomGenerator random, Direction direction) {
        boolean isSecondHalf = false;
        for (Element row : rows.get(direction)) {
            byte[] value = row.randomValue(random);
            if (row.format == Element.Format.HALF && isSecondHalf) {
                out.bytes(value).joinHalves();
            } else if (row.isMandatory() || random.nextBoolean()) {
                if (row.format.hasIdentifier()) {
                    out.octet(row.identifier);
                }
                if (row.format.hasLength()) {
                    out.octet(value.length);
                }
                out.bytes(value);
            }
            isSecondHalf = row.format == Element.Format.HALF && !isSecondHalf;
        }
    }

    /** The message of the octets. @param head values of the first components, which have no rows in the table */
    Object read(MessageReader in, Direction direction, Object... head) throws ProtocolViolation {
        List<Part> parts = split(in, direction);
        Object[] values = absent.clone();
        for (Part part : parts) {
            if (part.row().places.length > 0) {
                take(part, values, direction);
            }
        }
        System.arraycopy(head, 0, values, 0, head.length);
        for (Element row : rows.get(direction)) {
            if (row.isRequired() && parts.stream().noneMatch(part -> part.row() == row)) {
                throw ProtocolViolation.invalid(row.type().title() + " is missing");
            }
        }
        return construct(values);
    }

    private Object construct(Object[] values) throws ProtocolViolation {
        try {
            return (Object) constructor.invokeExact(values);
        } catch (IllegalArgumentException wrong) {
            throw ProtocolViolation.invalid(wrong.getMessage());
        } catch (Throwable impossible) {
            throw new AssertionError(impossible);
        }
    }

    private void take(Part part, Object[] values, Direction direction) throws ProtocolViolation {
        int[] places = part.row().places;
        int first = places[0];
        boolean isOptional = absent[first] != null;
        if (isOptional && values[first] != absent[first]) {
            return;
        }
        try {
            Object value = part.row().type().read(part.value(), direction);
            Object[] all = places.length == 1 ? new Object[] {value} : (Object[]) value;
            for (int i = 0; i < all.length; i++) {
                values[places[i]] = absent[places[i]] instanceof Optional ? Optional.of(all[i]) : all[i];
            }
        } catch (ProtocolViolation broken) {
            if (!isOptional) {
                throw broken;
            }
        }
    }

    /** The elements of the message in order, without those with identifiers unknown to the table. */
    List<Part> split(MessageReader in, Direction direction) throws ProtocolViolation {
        List<Part> parts = new ArrayList<>(rows.get(direction).size());
        boolean isSecondHalf = false;
        for (Element row : rows.get(direction)) {
            int from = in.position();
            if (row.format == Element.Format.HALF) {
                int octet = in.hasMore() && !isSecondHalf
                        ? in.peek()
                        : in.octet(row.type().title());
                byte[] half = {(byte) (isSecondHalf ? octet >> 4 : octet & 0x0f)};
                parts.add(new Part(row, new MessageReader(half), from, from + 1));
                isSecondHalf = !isSecondHalf;
            } else if (!row.format.hasIdentifier()) {
                String what = row.type().title();
                MessageReader value =
                        row.format.hasLength() ? in.lengthAndValue(what) : in.part(row.fixedLength(), what);
                parts.add(new Part(row, value, from, in.position()));
            }
        }
        while (in.hasMore()) {
            addTagged(parts, in, direction);
        }
        return parts;
    }

    private void addTagged(List<Part> parts, MessageReader in, Direction direction) throws ProtocolViolation {
        int from = in.position();
        int identifier = in.octet("element identifier");
        Element row = find(identifier, direction);
        if (identifier >= 0x80) {
            if (row != null) {
                parts.add(new Part(row, new MessageReader(new byte[0]), from, in.position()));
            }
            return;
        }
        if (row == null && identifier < 0x10) {
            throw ProtocolViolation.invalid(
                    String.format("element 0x%02x must be understood and is not known here", identifier));
        }
        int length;
        if (row != null && !row.format.hasLength()) {
            length = row.fixedLength();
        } else {
            length = in.hasMore() ? in.octet("element length") : 1;
        }
        if (length > in.remaining()) {
            in.skipRest();
            return;
        }
        MessageReader value = in.part(length, "element");
        if (row != null && row.allows(length)) {
            parts.add(new Part(row, value, from, in.position()));
        }
    }

    private Element find(int identifier, Direction direction) {
        for (Element row : rows.get(direction)) {
            if (row.identifier == identifier) {
                return row;
            }
        }
        return null;
    }
}
