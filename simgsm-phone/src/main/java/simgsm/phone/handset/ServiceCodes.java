package simgsm.phone.handset;

import java.util.Optional;
import java.util.function.Function;
import simgsm.air.Msisdn;
import simgsm.sim.PinLock;
import simgsm.ss.ServiceCode;
import simgsm.ss.UssdText;

/** Performs a user's input before the green key, and USSD (TS 22.030, 6.5 and 6.7). */
public final class ServiceCodes {
    private final Handset handset;

    ServiceCodes(Handset handset) {
        this.handset = handset;
    }

    /** Sends a service code, or calls a number. @throws IllegalArgumentException for any other text */
    public Optional<Refusal> perform(String typed) {
        if (ServiceCode.isCode(typed)) {
            return send(typed);
        }
        Msisdn number = Msisdn.parse(ServiceCode.called(typed));
        handset.station().hideNumber(ServiceCode.isHidingCall(typed));
        return handset.dial(number);
    }

    /** Sends a USSD code, or the reply awaited by the network. */
    public Optional<Refusal> send(String text) {
        if (!handset.isPowered()) {
            return Optional.of(Refusal.SWITCHED_OFF);
        }
        if (text.equals(ServiceCode.IMEI)) {
            showImei();
            return Optional.empty();
        }
        if (PinLock.isCode(text)) {
            return useCard(card -> card.perform(text));
        }
        if (!UssdText.fits(text)) {
            return Optional.of(text.isEmpty() ? Refusal.EMPTY_TEXT : Refusal.USSD_TOO_LONG);
        }
        if (!handset.station().snapshot().card().isReady()) {
            return Optional.of(Refusal.SIM_LOCKED);
        }
        boolean isSent = handset.station().sendUssd(text);
        if (isSent) {
            handset.home().clear();
            handset.screens().ussdSent(text);
            handset.changed();
        }
        return isSent ? Optional.empty() : Optional.of(Refusal.USSD_UNDER_WAY);
    }

    /** Gives the SIM a code of its user; its answer is shown. */
    public Optional<Refusal> useCard(Function<PinLock, PinLock.Result> command) {
        if (!handset.isPowered()) {
            return Optional.of(Refusal.SWITCHED_OFF);
        }
        PinLock.Result result = handset.station().useCard(command);
        handset.home().clear();
        handset.screens().cardAnswered(result, handset.station().snapshot().card());
        handset.changed();
        return result == PinLock.Result.REFUSED ? Optional.of(Refusal.SIM_REFUSES) : Optional.empty();
    }

    /** Shows the IMEI, without the network (TS 22.030, 6.7.2). */
    private void showImei() {
        String imei = handset.station().identity().imei().digits();
        handset.home().clear();
        handset.screens().showImei(imei);
        handset.report(new HandsetEvent.ImeiShown(imei));
    }
}
