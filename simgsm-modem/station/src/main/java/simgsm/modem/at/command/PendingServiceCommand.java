package simgsm.modem.at.command;

import java.util.Optional;
import java.util.function.Consumer;
import simgsm.modem.at.AtException;
import simgsm.modem.at.AtRequest;
import simgsm.modem.at.AtResult;
import simgsm.modem.at.CmeError;
import simgsm.ss.ServiceStatus;
import simgsm.ss.SsError;
import simgsm.station.context.StationEvent;

/**
 * The command that waits for the network's answer about a supplementary service; one at a time, as in the network.
 */
final class PendingServiceCommand {
    private final AtTerminal terminal;
    private Optional<AtRequest> asking = Optional.empty();
    private Consumer<ServiceStatus> answered = status -> {};

    PendingServiceCommand(AtTerminal terminal) {
        this.terminal = terminal;
    }

    /**
     * Asks the network.
     *
     * @param code as typed by a user, {@code *#21#}
     * @param told takes the service's status; OK follows
     */
    AtResult ask(AtRequest request, String code, Consumer<ServiceStatus> told) throws AtException {
        boolean isFree = asking.filter(former -> !former.isOver()).isEmpty();
        if (!isFree || !terminal.sendUssd(code)) {
            throw new AtException(CmeError.OPERATION_NOT_ALLOWED);
        }
        asking = Optional.of(request);
        answered = told;
        return AtResult.PENDING;
    }

    /** @return true if the event answers a command */
    boolean accept(StationEvent.OfUssd event) {
        if (asking.isEmpty()) {
            return false;
        }
        AtRequest request = asking.get();
        asking = Optional.empty();
        if (event instanceof StationEvent.ServiceAnswered answer) {
            if (!request.isOver()) {
                answered.accept(answer.status());
            }
            request.finish(AtResult.OK);
        } else if (event instanceof StationEvent.UssdEnded end) {
            request.finish(new AtResult.EquipmentError(errorOf(end)));
        } else {
            request.finish(AtResult.ERROR);
        }
        return true;
    }

    private static CmeError errorOf(StationEvent.UssdEnded end) {
        return switch (end.how()) {
            case NO_SERVICE -> CmeError.NO_NETWORK_SERVICE;
            case NO_ANSWER -> CmeError.NETWORK_TIMEOUT;
            case REFUSED ->
                end.error().equals(Optional.of(SsError.FACILITY_NOT_SUPPORTED))
                        ? CmeError.OPERATION_NOT_SUPPORTED
                        : CmeError.OPERATION_NOT_ALLOWED;
            default -> CmeError.UNKNOWN;
        };
    }
}
