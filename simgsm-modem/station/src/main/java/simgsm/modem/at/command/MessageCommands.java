package simgsm.modem.at.command;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Predicate;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.air.RelayMessage;
import simgsm.modem.at.AtCommandTable;
import simgsm.modem.at.AtException;
import simgsm.modem.at.AtParameters;
import simgsm.modem.at.AtRequest;
import simgsm.modem.at.AtResult;
import simgsm.modem.at.CmsError;
import simgsm.modem.at.sms.PduText;
import simgsm.modem.at.sms.TextSubmit;
import simgsm.modem.at.state.SimMemory;
import simgsm.octets.OctetString;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.Tpdu;

/** Short messages: send, store, list, read, delete (TS 27.005, 3.4, 3.5 and 4). */
final class MessageCommands {
    private static final AtResult BAD_PDU = new AtResult.MessageError(CmsError.INVALID_PDU_PARAMETER);
    private static final AtResult BAD_TEXT = new AtResult.MessageError(CmsError.INVALID_TEXT_PARAMETER);
    private static final AtResult BAD_INDEX = new AtResult.MessageError(CmsError.INVALID_MEMORY_INDEX);

    private static final int LEAST_PDU = 7;
    private static final List<String> DELETIONS =
            List.of("DEL READ", "DEL UNREAD", "DEL SENT", "DEL UNSENT", "DEL INBOX", "DEL ALL");

    private MessageCommands() {}

    static void addTo(AtCommandTable<AtClient> table) {
        table.row("+CMGS").setFor(MessageCommands::send);
        table.row("+CMGW").executeFor(MessageCommands::write).setFor(MessageCommands::write);
        table.row("+CMSS").setFor(MessageCommands::sendStored);
        table.row("+CMGC").setFor(MessageCommands::command);
        table.row("+CMGL")
                .testWith((client, request) -> request.answer(
                        client.settings().textMode
                                ? "(\"REC UNREAD\",\"REC READ\",\"STO UNSENT\",\"STO SENT\",\"ALL\")"
                                : "(0-4)"))
                .execute((client, request) ->
                        list(client, request, entry -> entry.status() == SimMemory.Status.RECEIVED_UNREAD))
                .set((client, request) -> list(client, request, selection(client, request)));
        table.row("+CMGR").set(MessageCommands::read);
        table.row("+CMGD").set(MessageCommands::delete);
        table.row("+CMGDA").set(MessageCommands::deleteAll);
        table.row("+CNMA").execute(MessageCommands::acknowledge).set(MessageCommands::acknowledge);
    }

    // ---- sending ------------------------------------------------------------------------------------------------

    private static AtResult send(AtClient client, AtRequest request) throws AtException {
        return client.settings().textMode ? sendText(client, request) : sendPdu(client, request, false);
    }

    private static AtResult sendPdu(AtClient client, AtRequest request, boolean isCommand) throws AtException {
        int length = pduLength(request.parameters().refusing(BAD_PDU).atMost(1));
        return request.prompt(false, entered -> {
            PduText pdu =
                    PduText.parse(entered, length, client.modem().messages().serviceCenter());
            return submit(client, request, pdu, isCommand ? pdu.commandReceiver() : pdu.receiver());
        });
    }

    private static int pduLength(AtParameters parameters) throws AtException {
        return parameters.number(0, LEAST_PDU, RelayMessage.MAX_TPDU_LENGTH);
    }

    private static AtResult command(AtClient client, AtRequest request) throws AtException {
        if (client.settings().textMode) {
            throw AtException.ofMessage(CmsError.OPERATION_NOT_SUPPORTED);
        }
        return sendPdu(client, request, true);
    }

    private static AtResult submit(AtClient client, AtRequest request, PduText pdu, Msisdn to) throws AtException {
        return client.modem()
                .submissions()
                .submit(request, pdu.tpdu(), to, pdu.serviceCenter(), reference -> request.answer(reference));
    }

    private static AtResult sendText(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().refusing(BAD_TEXT).atMost(2);
        TextSubmit submit = TextSubmit.to(client.settings(), parameters);
        return request.prompt(true, entered -> {
            SubmitTpdu tpdu = submit.message(entered);
            PduText pdu = new PduText(client.modem().messages().serviceCenter(), TextSubmit.octets(tpdu));
            return submit(client, request, pdu, pdu.receiver());
        });
    }

    private static AtResult sendStored(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().refusing(BAD_INDEX).atMost(3);
        int place = parameters.number(0, 1, SimMemory.CAPACITY);
        SimMemory memory = client.modem().messages().memory();
        SimMemory.Entry entry = memory.get(place).orElseThrow(parameters::refused);
        if (!(decoded(entry) instanceof SubmitTpdu stored)) {
            throw AtException.ofMessage(CmsError.OPERATION_NOT_ALLOWED);
        }
        OctetString octets = entry.tpdu();
        if (parameters.given(1).isPresent()) {
            octets = TextSubmit.octets(TextSubmit.readdressed(client.settings(), stored, parameters, 1));
        }
        PduText pdu = new PduText(client.modem().messages().serviceCenter(), octets);
        return client.modem()
                .submissions()
                .submit(request, pdu.tpdu(), pdu.receiver(), pdu.serviceCenter(), reference -> {
                    if (memory.get(place).equals(Optional.of(entry))) {
                        memory.setStatus(place, SimMemory.Status.STORED_SENT);
                    }
                    request.answer(reference);
                });
    }

    // ---- storing ------------------------------------------------------------------------------------------------

    private static AtResult write(AtClient client, AtRequest request) throws AtException {
        if (client.settings().textMode) {
            AtParameters parameters = request.parameters().refusing(BAD_TEXT).atMost(3);
            TextSubmit submit = TextSubmit.to(client.settings(), parameters);
            SimMemory.Status status = parameters
                    .given(2)
                    .map(words -> statusOf(words))
                    .orElse(Optional.of(SimMemory.Status.STORED_UNSENT))
                    .filter(named -> !named.isReceived())
                    .orElseThrow(parameters::refused);
            return request.prompt(
                    true, entered -> stored(client, request, status, TextSubmit.octets(submit.message(entered))));
        }
        AtParameters parameters = request.parameters().refusing(BAD_PDU).atMost(2);
        int length = pduLength(parameters);
        SimMemory.Status status = SimMemory.Status.values()[parameters.number(1, 0, 3, 2)];
        return request.prompt(false, entered -> {
            PduText pdu =
                    PduText.parse(entered, length, client.modem().messages().serviceCenter());
            boolean isSubmit = decoded(new SimMemory.Entry(status, pdu.tpdu(), 0)) instanceof SubmitTpdu;
            if (isSubmit == status.isReceived()) {
                throw AtException.ofMessage(CmsError.INVALID_PDU_PARAMETER);
            }
            return stored(client, request, status, pdu.tpdu());
        });
    }

    private static AtResult stored(AtClient client, AtRequest request, SimMemory.Status status, OctetString tpdu)
            throws AtException {
        OptionalInt place = client.modem().messages().memory().add(status, tpdu);
        request.answer(place.orElseThrow(() -> AtException.ofMessage(CmsError.MEMORY_FULL)));
        client.modem().messages().memoryChanged();
        return AtResult.OK;
    }

    // ---- reading ------------------------------------------------------------------------------------------------

    private static Optional<SimMemory.Status> statusOf(String words) {
        for (SimMemory.Status status : SimMemory.Status.values()) {
            if (status.words().equals(words.toUpperCase(Locale.ROOT))) {
                return Optional.of(status);
            }
        }
        return Optional.empty();
    }

    private static Predicate<SimMemory.Entry> selection(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters()
                .refusing(client.settings().textMode ? BAD_TEXT : BAD_PDU)
                .atMost(1);
        if (client.settings().textMode) {
            if (parameters.text(0).equalsIgnoreCase("ALL")) {
                return entry -> true;
            }
            SimMemory.Status wanted = statusOf(parameters.text(0)).orElseThrow(parameters::refused);
            return entry -> entry.status() == wanted;
        }
        int number = parameters.number(0, 0, 4);
        return entry -> number == 4 || entry.status().ordinal() == number;
    }

    private static void list(AtClient client, AtRequest request, Predicate<SimMemory.Entry> wanted) throws AtException {
        SimMemory memory = client.modem().messages().memory();
        for (int place = 1; place <= SimMemory.CAPACITY; place++) {
            Optional<SimMemory.Entry> entry = memory.get(place).filter(wanted);
            if (entry.isPresent()) {
                request.line("+CMGL: " + listed(client, place, entry.get()));
                markRead(client, place, entry.get());
            }
        }
    }

    private static String listed(AtClient client, int place, SimMemory.Entry entry) throws AtException {
        if (client.settings().textMode) {
            return client.modem()
                    .messages()
                    .textMode(client)
                    .listed(place, entry.status(), entry.tpdu(), decoded(entry));
        }
        PduText pdu = new PduText(client.modem().messages().serviceCenter(), entry.tpdu());
        return place + "," + entry.status().ordinal() + ",," + pdu.length() + "\r\n" + pdu.digits();
    }

    private static void read(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().refusing(BAD_INDEX).atMost(1);
        int place = parameters.number(0, 0, Integer.MAX_VALUE);
        SimMemory.Entry entry = client.modem().messages().memory().get(place).orElseThrow(parameters::refused);
        if (client.settings().textMode) {
            request.answer(
                    client.modem().messages().textMode(client).read(entry.status(), entry.tpdu(), decoded(entry)));
        } else {
            PduText pdu = new PduText(client.modem().messages().serviceCenter(), entry.tpdu());
            request.answer(entry.status().ordinal(), "", pdu.length() + "\r\n" + pdu.digits());
        }
        markRead(client, place, entry);
    }

    private static void markRead(AtClient client, int place, SimMemory.Entry entry) {
        if (entry.status() == SimMemory.Status.RECEIVED_UNREAD) {
            client.modem().messages().memory().setStatus(place, SimMemory.Status.RECEIVED_READ);
            client.modem().network().check();
        }
    }

    private static Tpdu decoded(SimMemory.Entry entry) throws AtException {
        try {
            return PduText.decode(entry.tpdu());
        } catch (ProtocolViolation broken) {
            throw AtException.ofMessage(CmsError.INVALID_PDU_PARAMETER);
        }
    }

    private static void delete(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().refusing(BAD_INDEX).atMost(2);
        int place = parameters.number(0, 0, Integer.MAX_VALUE);
        int flag = parameters.number(1, 0, 4, 0);
        SimMemory memory = client.modem().messages().memory();
        if (flag == 0) {
            if (!SimMemory.isPlace(place)) {
                throw parameters.refused();
            }
            memory.remove(place);
        } else {
            delete(memory, status -> isDeletedBy(flag, status));
        }
        client.modem().messages().memoryChanged();
    }

    private static void delete(SimMemory memory, Predicate<SimMemory.Status> wanted) {
        for (int place = 1; place <= SimMemory.CAPACITY; place++) {
            if (memory.get(place).filter(entry -> wanted.test(entry.status())).isPresent()) {
                memory.remove(place);
            }
        }
    }

    /** By number in PDU mode, by words in text mode (SIM800 Series AT Command Manual, 4.2.15). */
    private static void deleteAll(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().refusing(BAD_INDEX).atMost(1);
        int named = DELETIONS.indexOf(parameters.text(0).toUpperCase(Locale.ROOT));
        int kind = named >= 0 ? named + 1 : parameters.number(0, 1, DELETIONS.size());
        delete(client.modem().messages().memory(), status -> switch (kind) {
            case 1 -> status == SimMemory.Status.RECEIVED_READ;
            case 2 -> status == SimMemory.Status.RECEIVED_UNREAD;
            case 3 -> status == SimMemory.Status.STORED_SENT;
            case 4 -> status == SimMemory.Status.STORED_UNSENT;
            case 5 -> status.isReceived();
            default -> true;
        });
        client.modem().messages().memoryChanged();
    }

    private static boolean isDeletedBy(int flag, SimMemory.Status status) {
        return switch (status) {
            case RECEIVED_READ -> true;
            case STORED_SENT -> flag >= 2;
            case STORED_UNSENT -> flag >= 3;
            case RECEIVED_UNREAD -> flag == 4;
        };
    }

    private static void acknowledge(AtClient client, AtRequest request) throws AtException {
        request.parameters().refusing(BAD_PDU).atMost(2).number(0, 0, 2, 0);
        if (!client.modem().messages().acknowledge(client)) {
            throw AtException.ofMessage(CmsError.NO_ACKNOWLEDGEMENT_EXPECTED);
        }
    }
}
