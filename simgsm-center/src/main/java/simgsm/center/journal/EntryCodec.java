package simgsm.center.journal;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.time.DateTimeException;
import java.time.Instant;
import java.util.Optional;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.center.smsc.EsmeOrigin;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.ShortMessage;
import simgsm.center.smsc.StoreEntry;
import simgsm.octets.OctetString;
import simgsm.sms.SmsAddress;

/**
 * Converts store entries to octets and back: the kind, then the fields in order, in the format of {@link
 * DataOutputStream}.
 */
final class EntryCodec {
    private static final int ACCEPTED = 1;
    private static final int ENDED = 2;
    private static final int REPORTED = 3;
    private static final int KNOWN = 4;
    private static final int NUMBERED = 5;
    /** An accepted message with its place in a submission and its time of delivery. */
    private static final int ACCEPTED_WITH_PLACE = 6;

    /** A subscriber with services. */
    private static final int KNOWN_WITH_SERVICES = 7;

    /** An accepted message with its place, time of delivery and service type. */
    private static final int ACCEPTED_WITH_SERVICE_TYPE = 8;

    private EntryCodec() {}

    static byte[] encode(StoreEntry entry) {
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        try {
            write(entry, new DataOutputStream(octets));
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
        return octets.toByteArray();
    }

    private static void write(StoreEntry entry, DataOutputStream to) throws IOException {
        if (entry instanceof StoreEntry.Accepted accepted) {
            Optional<EsmeOrigin> placed = accepted.message()
                    .esme()
                    .filter(origin -> !origin.group().equals(EsmeOrigin.Group.SINGLE)
                            || origin.deliverAt().isPresent()
                            || !origin.serviceType().isEmpty());
            boolean hasType = placed.isPresent() && !placed.get().serviceType().isEmpty();
            to.writeByte(hasType ? ACCEPTED_WITH_SERVICE_TYPE : placed.isPresent() ? ACCEPTED_WITH_PLACE : ACCEPTED);
            write(accepted.message(), to);
            if (placed.isPresent()) {
                writePlace(placed.get(), to);
            }
            if (hasType) {
                to.writeUTF(placed.get().serviceType());
            }
        } else if (entry instanceof StoreEntry.Ended ended) {
            to.writeByte(ENDED);
            to.writeLong(ended.id());
            to.writeUTF(ended.state().name());
            write(ended.at(), to);
            to.writeBoolean(ended.reportFollows());
        } else if (entry instanceof StoreEntry.Reported reported) {
            to.writeByte(REPORTED);
            to.writeLong(reported.id());
        } else if (entry instanceof StoreEntry.Known known) {
            boolean hasServices = !known.services().isEmpty();
            to.writeByte(hasServices ? KNOWN_WITH_SERVICES : KNOWN);
            to.writeUTF(known.number().digits());
            to.writeUTF(known.imsi().digits());
            if (hasServices) {
                to.writeUTF(known.services());
            }
        } else if (entry instanceof StoreEntry.Numbered numbered) {
            to.writeByte(NUMBERED);
            to.writeLong(numbered.lastId());
        }
    }

    private static void write(ShortMessage message, DataOutputStream to) throws IOException {
        to.writeLong(message.id());
        to.writeUTF(message.from().digits());
        to.writeUTF(message.to().digits());
        to.writeShort(message.submit().length());
        to.write(message.submit().toArray());
        write(message.acceptedAt(), to);
        write(message.expiresAt(), to);
        to.writeBoolean(message.esme().isPresent());
        if (message.esme().isPresent()) {
            write(message.esme().get(), to);
        }
    }

    private static void write(EsmeOrigin origin, DataOutputStream to) throws IOException {
        to.writeUTF(origin.systemId());
        to.writeByte(origin.source().type());
        to.writeByte(origin.source().plan());
        to.writeUTF(origin.source().value());
        to.writeByte(origin.dataCoding());
        to.writeUTF(origin.receipts().name());
    }

    private static void writePlace(EsmeOrigin origin, DataOutputStream to) throws IOException {
        to.writeInt(origin.group().before());
        to.writeInt(origin.group().after());
        to.writeBoolean(origin.deliverAt().isPresent());
        if (origin.deliverAt().isPresent()) {
            write(origin.deliverAt().get(), to);
        }
    }

    private static void write(Instant instant, DataOutputStream to) throws IOException {
        to.writeLong(instant.getEpochSecond());
        to.writeInt(instant.getNano());
    }

    /**
     * @param shared holds the numbers and origins of earlier entries
     * @throws IOException if the octets are not an entry in this format
     */
    static StoreEntry decode(byte[] octets, SharedValues shared) throws IOException {
        DataInputStream from = new DataInputStream(new ByteArrayInputStream(octets));
        try {
            return read(from, shared);
        } catch (IllegalArgumentException | DateTimeException e) {
            throw new IOException("an invalid entry: " + e.getMessage(), e);
        }
    }

    private static StoreEntry read(DataInputStream from, SharedValues shared) throws IOException {
        int kind = from.readUnsignedByte();
        return switch (kind) {
            case ACCEPTED -> new StoreEntry.Accepted(readMessage(from, shared));
            case ACCEPTED_WITH_PLACE, ACCEPTED_WITH_SERVICE_TYPE ->
                new StoreEntry.Accepted(
                        readPlace(readMessage(from, shared), from, shared, kind == ACCEPTED_WITH_SERVICE_TYPE));
            case ENDED ->
                new StoreEntry.Ended(
                        from.readLong(), MessageState.valueOf(from.readUTF()), readInstant(from), from.readBoolean());
            case REPORTED -> new StoreEntry.Reported(from.readLong());
            case KNOWN -> new StoreEntry.Known(new Msisdn(from.readUTF()), new Imsi(from.readUTF()));
            case KNOWN_WITH_SERVICES ->
                new StoreEntry.Known(new Msisdn(from.readUTF()), new Imsi(from.readUTF()), from.readUTF());
            case NUMBERED -> new StoreEntry.Numbered(from.readLong());
            default -> throw new IOException("an entry of unknown kind " + kind);
        };
    }

    private static ShortMessage readMessage(DataInputStream from, SharedValues shared) throws IOException {
        return new ShortMessage(
                from.readLong(),
                shared.of(new Msisdn(from.readUTF())),
                shared.of(new Msisdn(from.readUTF())),
                OctetString.of(from.readNBytes(from.readUnsignedShort())),
                readInstant(from),
                readInstant(from),
                from.readBoolean() ? shared.of(Optional.of(readOrigin(from))) : Optional.empty());
    }

    private static ShortMessage readPlace(
            ShortMessage message, DataInputStream from, SharedValues shared, boolean hasServiceType)
            throws IOException {
        EsmeOrigin origin =
                message.esme().orElseThrow(() -> new IOException("a place in a submission, but no application"));
        EsmeOrigin.Group place = new EsmeOrigin.Group(from.readInt(), from.readInt());
        Optional<Instant> deliverAt = from.readBoolean() ? Optional.of(readInstant(from)) : Optional.empty();
        return new ShortMessage(
                message.id(),
                message.from(),
                message.to(),
                message.submit(),
                message.acceptedAt(),
                message.expiresAt(),
                shared.of(Optional.of(new EsmeOrigin(
                        origin.systemId(),
                        origin.source(),
                        origin.dataCoding(),
                        origin.receipts(),
                        place,
                        deliverAt,
                        hasServiceType ? from.readUTF() : ""))));
    }

    private static EsmeOrigin readOrigin(DataInputStream from) throws IOException {
        return new EsmeOrigin(
                from.readUTF(),
                new SmsAddress(from.readUnsignedByte(), from.readUnsignedByte(), from.readUTF()),
                from.readUnsignedByte(),
                EsmeOrigin.Receipts.valueOf(from.readUTF()));
    }

    private static Instant readInstant(DataInputStream from) throws IOException {
        return Instant.ofEpochSecond(from.readLong(), from.readInt());
    }
}
