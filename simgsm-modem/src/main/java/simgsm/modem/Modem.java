package simgsm.modem;

import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.station.MobileStation;
import simgsm.station.Sim;
import simgsm.station.StationIdentity;

/**
 * M2 as a deterministic core: it owns a station and speaks for it. It alerts and connects every call at once, clears it with
 * cause 16 after 60 s without a key while no order is under way, and with cause 41 after 2 s without a speech frame.
 */
public final class Modem {
    public Modem(StationIdentity identity, Sim sim, ModemListener listener) {
        throw new UnsupportedOperationException();
    }

    /** For the thread that gives it time and a socket. */
    public MobileStation station() {
        throw new UnsupportedOperationException();
    }

    /** Queues a reply tone of 150 ms, 70 ms from its neighbours; without an accepted call it is dropped. */
    public void sendTone(DtmfKey key) {
        throw new UnsupportedOperationException();
    }

    /** @return the message reference of the first part */
    public int sendSms(Msisdn to, String text) {
        throw new UnsupportedOperationException();
    }

    /** While an order is under way the count of 60 s stands still; it starts again at every reply tone. */
    public void setOrderUnderWay(boolean underWay) {
        throw new UnsupportedOperationException();
    }

    /** Ends the call with cause 16. @return false if there is none */
    public boolean hangUp() {
        throw new UnsupportedOperationException();
    }
}
