package simgsm.modem.at.command;

import java.util.function.Function;
import simgsm.modem.at.AddressType;
import simgsm.modem.at.AtCommandTable;
import simgsm.modem.at.AtException;
import simgsm.modem.at.AtParameters;
import simgsm.modem.at.AtRequest;
import simgsm.modem.at.CmeError;
import simgsm.modem.at.state.SimFiles;
import simgsm.sim.CardPin;
import simgsm.sim.PinLock;

/** The SIM (TS 27.007, 5, 7 and 8). */
final class SimCommands {
    private SimCommands() {}

    static void addTo(AtCommandTable<AtClient> table) {
        table.row("+CPIN")
                .read((client, request) -> {
                    requireReadable(client);
                    request.answer(demand(status(client)));
                })
                .set(SimCommands::enterCode);
        table.row("+CIMI").execute((client, request) -> {
            requireReady(client);
            request.line(client.modem().terminal().station().identity().imsi().digits());
        });
        table.row("+CNUM").execute((client, request) -> {
            requireReady(client);
            String number =
                    client.modem().terminal().station().identity().number().toString();
            request.answer("\"\"", AtRequest.quoted(number), AddressType.of(number));
        });
        table.row("+CCID")
                .execute((client, request) -> request.line(
                        client.modem().profile().cardNumber(files(client).iccid())));
        table.row("+SPIC").execute((client, request) -> {
            PinLock.Status card = status(client);
            request.answer(card.pinTries(), card.pukTries(), CardPin.TRIES, CardPin.PUK_TRIES);
        });
        table.row("+CPINR").execute((client, request) -> {
            request.answer("SIM PIN", status(client).pinTries(), CardPin.TRIES);
            request.answer("SIM PUK", status(client).pukTries(), CardPin.PUK_TRIES);
        });
        table.row("+CPWD").set(SimCommands::changePin);
        table.row("+CLCK").set(SimCommands::lock);
        table.row("+CRSM").set(SimCommands::restrictedAccess);
    }

    private static SimFiles files(AtClient client) {
        return new SimFiles(
                client.modem().terminal().station().identity(),
                client.modem().network().operatorName());
    }

    static PinLock.Status status(AtClient client) {
        return client.modem().terminal().station().snapshot().card();
    }

    /** The code that the card demands (TS 27.007, 8.3); of a blocked one the SIM800's word. */
    static String demand(PinLock.Status card) {
        return switch (card.state()) {
            case READY -> "READY";
            case PIN -> "SIM PIN";
            case PUK -> "SIM PUK";
            case BLOCKED -> "NOT READY";
        };
    }

    private static void requireReadable(AtClient client) throws AtException {
        if (status(client).state() == PinLock.State.BLOCKED) {
            throw new AtException(CmeError.SIM_FAILURE);
        }
    }

    static void requireReady(AtClient client) throws AtException {
        requireReadable(client);
        if (!status(client).isReady()) {
            boolean asksForPin = status(client).state() == PinLock.State.PIN;
            throw new AtException(asksForPin ? CmeError.SIM_PIN_REQUIRED : CmeError.SIM_PUK_REQUIRED);
        }
    }

    /** Gives the card a command of its user. */
    static void useCard(AtClient client, Function<PinLock, PinLock.Result> command) throws AtException {
        switch (client.modem().terminal().station().useCard(command)) {
            case DONE -> {}
            case WRONG ->
                throw new AtException(
                        status(client).pinTries() == 0 ? CmeError.SIM_PUK_REQUIRED : CmeError.INCORRECT_PASSWORD);
            case REFUSED -> throw new AtException(CmeError.OPERATION_NOT_ALLOWED);
        }
    }

    private static void enterCode(AtClient client, AtRequest request) throws AtException {
        AtParameters codes = request.parameters().atMost(2);
        switch (status(client).state()) {
            case PIN -> useCard(client, card -> card.verify(codes.text(0)));
            case PUK -> {
                String next = pin(codes, 1);
                useCard(client, card -> card.unblock(codes.text(0), next));
            }
            case READY, BLOCKED -> throw new AtException(CmeError.OPERATION_NOT_ALLOWED);
        }
    }

    private static String pin(AtParameters parameters, int index) throws AtException {
        if (!CardPin.isPin(parameters.text(index))) {
            throw parameters.refused();
        }
        return parameters.text(index);
    }

    private static void changePin(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().atMost(3);
        requireSimLock(parameters);
        String next = pin(parameters, 2);
        useCard(client, card -> card.change(parameters.text(1), next));
    }

    private static void requireSimLock(AtParameters parameters) throws AtException {
        if (!parameters.text(0).equalsIgnoreCase("SC")) {
            throw new AtException(CmeError.OPERATION_NOT_SUPPORTED);
        }
    }

    private static void lock(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().atMost(4);
        int mode = parameters.number(1, 0, 2);
        requireSimLock(parameters);
        if (mode == 2) {
            request.answer(status(client).isEnabled() ? 1 : 0);
        } else {
            useCard(client, card -> card.enable(mode == 1, parameters.text(2)));
        }
    }

    private static void restrictedAccess(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().atMost(7);
        SimFiles.Answer answer = files(client)
                .access(
                        parameters.number(0, 0, 255),
                        parameters.number(1, 0, 0xffff, 0),
                        parameters.number(2, 0, 255, 0),
                        parameters.number(3, 0, 255, 0),
                        parameters.number(4, 0, 255, 0));
        if (answer.data().isEmpty()) {
            request.answer(answer.status1(), answer.status2());
        } else {
            request.answer(answer.status1(), answer.status2(), AtRequest.quoted(answer.data()));
        }
    }
}
