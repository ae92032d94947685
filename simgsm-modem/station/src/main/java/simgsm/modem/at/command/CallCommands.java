package simgsm.modem.at.command;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import simgsm.air.Msisdn;
import simgsm.modem.at.AtCommandTable;
import simgsm.modem.at.AtException;
import simgsm.modem.at.AtParameters;
import simgsm.modem.at.AtRequest;
import simgsm.modem.at.AtResult;
import simgsm.modem.at.AtSound;
import simgsm.modem.at.CmeError;
import simgsm.modem.at.KeyRun;
import simgsm.modem.at.state.PhoneBooks;
import simgsm.sim.SimPhoneBook;
import simgsm.ss.ServiceCode;

/** Calls and keys (V.250, 6.3; TS 27.007, 6, 7 and C.2). */
final class CallCommands {
    /** Signs that only structure a dial string, and modifiers for lines other than GSM. */
    private static final String IGNORED_IN_NUMBERS = " -()/.TPWtpw,!@";

    private CallCommands() {}

    static void addTo(AtCommandTable<AtClient> table) {
        table.row("D").executeFor(CallCommands::dial);
        table.row("A").executeFor((client, request) -> client.modem().calls().answer(request));
        table.row("H").execute((client, request) -> {
            request.basicNumber(0);
            client.modem().calls().hangUp(client);
        });
        table.row("+CHUP").execute((client, request) -> client.modem().calls().hangUp(client));
        table.row("+CHLD")
                .testWith((client, request) ->
                        request.answer(client.modem().terminal().hasCallWaiting() ? "(0,1,2)" : "(0,1)"))
                .set(CallCommands::supplementary);
        table.row("+CLCC")
                .execute((client, request) -> client.modem().calls().list().forEach(request::answer));
        table.row("+CPAS")
                .execute((client, request) -> request.answer(
                        client.modem().calls().isRinging()
                                ? 3
                                : client.modem().calls().list().isEmpty() ? 0 : 4));
        table.row("+CEER")
                .execute((client, request) -> request.answer(client.modem()
                        .calls()
                        .lastCause()
                        .map(cause -> cause.code() + "," + AtRequest.quoted(cause.title()))
                        .orElse("\"no cause\"")));
        table.row("+CUSD")
                .read((client, request) -> request.answer(client.settings().ussdMode))
                .set(CallCommands::ussd);
        codes(table);
        ServiceCommands.addTo(table);
        keys(table);
        sound(table);
    }

    /** Huawei's commands, for clients that take the sound of a call. */
    private static void sound(AtCommandTable<AtClient> table) {
        table.row("^CVOICE")
                .testWith((client, request) -> answer(client, request, "(0)"))
                .read((client, request) -> answer(client, request, "0,8000,16,20"))
                .set((client, request) -> {
                    sound(client);
                    request.parameters().atMost(1).number(0, 0, 0);
                });
        table.row("^DDSETEX")
                .testWith((client, request) -> answer(client, request, "(2)"))
                .set((client, request) ->
                        sound(client).setOn(request.parameters().number(0, 2, 2) == 2));
        table.row("^DTMF").setFor((client, request) -> {
            request.parameters().number(0, 1, 1);
            return sendKeys(client, request, request.command().parameters().replaceFirst("[^,]*,?", ""));
        });
    }

    private static void answer(AtClient client, AtRequest request, String values) throws AtException {
        sound(client);
        request.answer(values);
    }

    private static AtSound sound(AtClient client) throws AtException {
        AtSound sound = client.modem().sound();
        if (!sound.isOffered()) {
            throw new AtException(AtResult.ERROR);
        }
        client.settings().takesSound = true;
        return sound;
    }

    private static void codes(AtCommandTable<AtClient> table) {
        table.row("+CLIP")
                .read((client, request) -> request.answer(client.settings().showsCaller ? 1 : 0, 1))
                .set((client, request) -> client.settings().showsCaller = flag(request));
        table.row("+CRC")
                .read((client, request) -> request.answer(client.settings().namesRingKind ? 1 : 0))
                .execute((client, request) -> client.settings().namesRingKind = false)
                .set((client, request) -> client.settings().namesRingKind = flag(request));
        table.row("+COLP")
                .read((client, request) -> request.answer(client.settings().showsConnectedNumber ? 1 : 0, 1))
                .set((client, request) -> client.settings().showsConnectedNumber = flag(request));
        for (String name : List.of("+CLDTMF", "+STTONE")) {
            table.row(name)
                    .set((client, request) -> request.parameters().atMost(3).number(0, 0, 100));
        }
    }

    private static void keys(AtCommandTable<AtClient> table) {
        table.row("+VTS")
                .setFor((client, request) ->
                        sendKeys(client, request, request.command().parameters()));
        table.row("+VTD")
                .read((client, request) -> request.answer(client.settings().keyTenths))
                .set((client, request) -> client.settings().keyTenths =
                        request.parameters().atMost(1).number(0, 0, 255));
        table.row("+DDET")
                .read((client, request) -> request.answer(
                        client.settings().reportsKeys ? 1 : 0,
                        client.settings().equalKeysMillis,
                        client.settings().reportsKeyMillis ? 1 : 0,
                        0))
                .set(CallCommands::detectKeys);
    }

    private static boolean flag(AtRequest request) throws AtException {
        return request.parameters().atMost(1).number(0, 0, 1) == 1;
    }

    private static AtResult dial(AtClient client, AtRequest request) throws AtException {
        String text = request.command().parameters();
        if (!text.endsWith(";")) {
            return AtResult.NO_CARRIER;
        }
        String dialled = number(client, text.substring(0, text.length() - 1).strip());
        if (ServiceCode.isCode(dialled)) {
            client.modem().ussd().send(client, dialled, true);
            return AtResult.OK;
        }
        Msisdn to;
        try {
            to = Msisdn.parse(ServiceCode.called(dialled));
        } catch (IllegalArgumentException notANumber) {
            throw new AtException(CmeError.INVALID_DIAL_STRING);
        }
        if (!to.isEmergency()) {
            SimCommands.requireReady(client);
        }
        client.modem().terminal().station().hideNumber(hides(client, text, dialled));
        if (!client.modem().calls().dial(dialled, to)) {
            throw new AtException(CmeError.OPERATION_NOT_ALLOWED);
        }
        return AtResult.OK;
    }

    /** The code #31#, or the modifier I, or +CLIR=1; *31# and i show the number (TS 27.007, 6.2 and 7.7). */
    private static boolean hides(AtClient client, String typed, String dialled) {
        if (ServiceCode.called(dialled).equals(dialled)) {
            String modifiers = typed.replaceFirst("(?s)^.*?([IiGg]*);$", "$1");
            return modifiers.contains("I")
                    || !modifiers.contains("i")
                            && KeptSettings.kept(client, "+CLIR").equals("1");
        }
        return ServiceCode.isHidingCall(dialled);
    }

    private static String number(AtClient client, String text) throws AtException {
        PhoneBooks books = client.modem().books();
        if (text.equalsIgnoreCase("L")) {
            return books.lastDialled().orElseThrow(() -> new AtException(CmeError.NOT_FOUND));
        }
        if (text.startsWith(">")) {
            return fromPhoneBook(client, text.substring(1).strip());
        }
        StringBuilder digits = new StringBuilder();
        String marked = text.replaceFirst("[IiGg]+$", "");
        marked.chars().filter(sign -> IGNORED_IN_NUMBERS.indexOf(sign) < 0).forEach(sign -> digits.append((char) sign));
        return digits.toString();
    }

    private static String fromPhoneBook(AtClient client, String wanted) throws AtException {
        boolean isName = wanted.startsWith("\"") && wanted.endsWith("\"") && wanted.length() > 1;
        String book = wanted.length() > 2 && Character.isLetter(wanted.charAt(0))
                ? wanted.substring(0, 2).toUpperCase(Locale.ROOT)
                : PhoneBooks.SIM;
        String place = wanted.replaceFirst("^[A-Za-z]{2}", "");
        PhoneBooks books = client.modem().books();
        if (!books.names().contains(book)) {
            throw new AtException(CmeError.INVALID_INDEX);
        }
        Map<Integer, SimPhoneBook.Entry> entries = books.entries(isName ? PhoneBooks.SIM : book);
        for (Map.Entry<Integer, SimPhoneBook.Entry> entry : entries.entrySet()) {
            boolean isMeant = isName
                    ? entry.getValue().name().equals(wanted.substring(1, wanted.length() - 1))
                    : entry.getKey().toString().equals(place);
            if (isMeant) {
                return entry.getValue().number();
            }
        }
        throw new AtException(isName ? CmeError.NOT_FOUND : CmeError.INVALID_INDEX);
    }

    private static void supplementary(AtClient client, AtRequest request) throws AtException {
        int operation = request.parameters().atMost(1).number(0, 0, 4);
        if (operation > 2) {
            throw new AtException(CmeError.OPERATION_NOT_SUPPORTED);
        }
        if (!client.modem().calls().supplementary(operation, client)) {
            throw new AtException(CmeError.OPERATION_NOT_ALLOWED);
        }
    }

    private static void ussd(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().atMost(3);
        int mode = parameters.number(0, 0, 2, client.settings().ussdMode);
        parameters.number(2, 0, 255, 0);
        if (mode == 2) {
            client.modem().terminal().station().endUssd();
            return;
        }
        client.settings().ussdMode = mode;
        if (parameters.given(1).isPresent()) {
            String text = client.settings().characterSet.decodeUssd(parameters.text(1));
            client.modem().ussd().send(client, text, false);
        }
    }

    private static AtResult sendKeys(AtClient client, AtRequest request, String keys) throws AtException {
        List<KeyRun> runs = KeyRun.parse(keys, client.settings().keyTenths);
        if (!client.modem().calls().isActive()) {
            throw new AtException(CmeError.OPERATION_NOT_ALLOWED);
        }
        return client.modem().calls().sendKeys(request, runs);
    }

    private static void detectKeys(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().atMost(4);
        int mode = parameters.number(0, 0, 1);
        int interval = parameters.number(1, 0, 10_000, 0);
        int report = parameters.number(2, 0, 1, 0);
        if (parameters.number(3, 0, 1, 0) == 1) {
            throw new AtException(CmeError.OPERATION_NOT_SUPPORTED);
        }
        client.settings().reportsKeys = mode == 1;
        client.settings().equalKeysMillis = interval;
        client.settings().reportsKeyMillis = report == 1;
    }
}
