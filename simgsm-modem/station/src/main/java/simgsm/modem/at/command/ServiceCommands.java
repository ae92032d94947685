package simgsm.modem.at.command;

import java.util.List;
import simgsm.air.Msisdn;
import simgsm.modem.at.AddressType;
import simgsm.modem.at.AtCommandTable;
import simgsm.modem.at.AtException;
import simgsm.modem.at.AtParameters;
import simgsm.modem.at.AtRequest;
import simgsm.modem.at.AtResult;
import simgsm.modem.at.CmeError;
import simgsm.ss.ServiceStatus;
import simgsm.ss.SsCode;

/** Supplementary services of the network: forwarding, call waiting, hidden numbers (TS 27.007, 7.7, 7.11, 7.12). */
final class ServiceCommands {
    /** By the reason's number. */
    private static final List<SsCode> REASONS = List.of(
            SsCode.FORWARDING_UNCONDITIONAL,
            SsCode.FORWARDING_ON_BUSY,
            SsCode.FORWARDING_ON_NO_REPLY,
            SsCode.FORWARDING_ON_NOT_REACHABLE,
            SsCode.ALL_FORWARDING,
            SsCode.ALL_CONDITIONAL_FORWARDING);

    /** Codes typed for the procedures 0 to 4: deactivate, activate, ask, register, erase. */
    private static final List<String> PROCEDURES = List.of("#", "*", "*#", "**", "##");

    private static final int QUERY = 2;
    private static final int REGISTER = 3;
    private static final int VOICE = 1;
    /** Voice, data and fax: the class of a command without one. */
    private static final int ALL_CLASSES = 7;

    private static final int MOST_CLASSES = 255;
    private static final int MOST_TYPE = 255;
    private static final int MOST_PARAMETERS = 8;
    private static final int MOST_SECONDS = 30;
    /** Temporary mode, shown unless hidden (TS 27.007, 7.7). */
    private static final int CLIR_PER_CALL = 4;

    private ServiceCommands() {}

    static void addTo(AtCommandTable<AtClient> table) {
        table.row("+CCFC").setFor(ServiceCommands::forward);
        table.row("+CCWA")
                .read((client, request) -> request.answer(client.settings().showsWaiting ? 1 : 0))
                .setFor(ServiceCommands::callWaiting);
        table.row("+CLIR")
                .read((client, request) -> request.answer(KeptSettings.kept(client, "+CLIR"), CLIR_PER_CALL))
                .set((client, request) -> {
                    request.parameters().atMost(1).number(0, 0, 2);
                    KeptSettings.keep(client, request);
                });
    }

    private static AtResult forward(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().atMost(MOST_PARAMETERS);
        SsCode reason = REASONS.get(parameters.number(0, 0, REASONS.size() - 1));
        int mode = parameters.number(1, 0, PROCEDURES.size() - 1);
        int type = parameters.number(3, 0, MOST_TYPE, AddressType.UNKNOWN);
        int classes = parameters.number(4, 1, MOST_CLASSES, ALL_CLASSES);
        if (isWithoutSpeech(classes, mode)) {
            request.answer(0, classes);
            return AtResult.OK;
        }
        String seconds = parameters.given(7).isEmpty() ? "" : "**" + parameters.number(7, 1, MOST_SECONDS, 1);
        String number = mode == REGISTER ? "*" + number(parameters, type) + seconds : "";
        String code = PROCEDURES.get(mode) + reason.typed() + number + "#";
        return client.modem().services().ask(request, code, status -> {
            if (mode == QUERY) {
                request.answer(forwarding(status, classes));
            }
        });
    }

    private static String number(AtParameters parameters, int type) throws AtException {
        String text = parameters.text(2);
        String number = type == AddressType.INTERNATIONAL && !text.startsWith("+") ? "+" + text : text;
        try {
            Msisdn.parse(number);
        } catch (IllegalArgumentException notANumber) {
            throw parameters.refused();
        }
        return number;
    }

    /** The network serves calls of speech: for other classes alone a service is inactive and cannot be set. */
    private static boolean isWithoutSpeech(int classes, int mode) throws AtException {
        boolean isWithout = (classes & VOICE) == 0;
        if (isWithout && mode != QUERY) {
            throw new AtException(CmeError.OPERATION_NOT_SUPPORTED);
        }
        return isWithout;
    }

    private static String forwarding(ServiceStatus status, int classes) {
        int active = status.isActive() ? 1 : 0;
        return status.forwardedTo()
                .map(number -> active + "," + VOICE + "," + AtRequest.quoted(number) + "," + AddressType.of(number)
                        + status.noReplySeconds()
                                .map(seconds -> ",,," + seconds)
                                .orElse(""))
                .orElse(active + "," + classes);
    }

    private static AtResult callWaiting(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().atMost(3);
        boolean shows = parameters.number(0, 0, 1, client.settings().showsWaiting ? 1 : 0) == 1;
        int classes = parameters.number(2, 1, MOST_CLASSES, ALL_CLASSES);
        if (parameters.given(1).isEmpty()) {
            client.settings().showsWaiting = shows;
            return AtResult.OK;
        }
        int mode = parameters.number(1, 0, QUERY);
        boolean isWithoutSpeech = isWithoutSpeech(classes, mode);
        client.settings().showsWaiting = shows;
        if (isWithoutSpeech) {
            request.answer(0, classes);
            return AtResult.OK;
        }
        if (!client.modem().terminal().hasCallWaiting()) {
            return withoutWaiting(request, mode, classes);
        }
        String code = PROCEDURES.get(mode) + SsCode.CALL_WAITING.typed() + "#";
        return client.modem().services().ask(request, code, status -> {
            if (mode == QUERY) {
                request.answer(status.isActive() ? 1 : 0, status.isActive() ? VOICE : classes);
            }
        });
    }

    /** A terminal without call waiting has nothing to ask the network for. */
    private static AtResult withoutWaiting(AtRequest request, int mode, int classes) throws AtException {
        if (mode == QUERY) {
            request.answer(0, classes);
        } else if (mode != 0) {
            throw new AtException(CmeError.OPERATION_NOT_SUPPORTED);
        }
        return AtResult.OK;
    }
}
