package simgsm.phone.handset;

import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.air.RpCause;
import simgsm.dtmf.DtmfKey;
import simgsm.station.StationListener;
import simgsm.station.StationSnapshot;

/** What the station tells the handset: first the handset's own state follows, then its listener is told. */
final class StationEars implements StationListener {
    private final Handset handset;
    private final HandsetListener listener;

    StationEars(Handset handset, HandsetListener listener) {
        this.handset = handset;
        this.listener = listener;
    }

    @Override
    public void registered(Msisdn number) {
        handset.changed();
        listener.registered(number);
    }

    @Override
    public void unregistered(Optional<RejectCause> cause) {
        handset.changed();
        listener.unregistered(cause);
    }

    @Override
    public void calling(Msisdn number) {
        handset.callBegan(CallPhase.CALLING, number.digits());
        listener.calling(number);
    }

    @Override
    public void alerting() {
        handset.callAlerts();
        listener.alerting();
    }

    @Override
    public void ringing(Optional<Msisdn> from) {
        handset.callBegan(CallPhase.RINGING, from.map(Msisdn::digits).orElse(""));
        listener.ringing(from);
    }

    @Override
    public boolean takesWaitingCalls() {
        return true;
    }

    @Override
    public void waiting(Optional<Msisdn> from) {
        handset.callWaits(from.map(Msisdn::digits).orElse(""));
        listener.waiting(from);
    }

    @Override
    public void waitingOver() {
        handset.waitingCallIsOver();
        listener.waitingOver();
    }

    @Override
    public void connected(Optional<Msisdn> peer) {
        handset.callConnected(peer.map(Msisdn::digits));
        listener.connected(peer);
    }

    @Override
    public void released(Cause cause) {
        handset.callEnded(cause);
        listener.released(cause);
        handset.checkSettled();
    }

    @Override
    public void networkTones(boolean heard) {
        handset.networkTones(heard);
    }

    @Override
    public void speechReceived(short[] samples) {
        handset.hear(samples);
    }

    @Override
    public void keySounds(DtmfKey key) {
        handset.signalledKeys().sounds(key);
    }

    @Override
    public void keyLetGo(DtmfKey key) {
        handset.signalledKeys().letGo();
    }

    @Override
    public void keyLeft(DtmfKey key) {
        handset.signalledKeys().left(key);
        handset.checkSettled();
    }

    @Override
    public void keysRefused(Cause cause) {
        listener.keysRefused(handset.keysRefused(cause), cause);
        handset.checkSettled();
    }

    @Override
    public void messageSent(int id, Msisdn to, int parts) {
        handset.messages().sent(id, parts);
        listener.messageSent(to, parts, id);
        handset.checkSettled();
    }

    @Override
    public void messageFailed(int id, Msisdn to, RpCause cause) {
        handset.messages().failed(id, cause);
        listener.messageFailed(to, cause);
        handset.checkSettled();
    }

    @Override
    public void messageReceived(String from, String text) {
        handset.messages().received(from, text);
        listener.messageReceived(from, text);
    }

    @Override
    public void messageDelivered(int id, Msisdn to) {
        handset.messages().delivered(id);
        listener.messageDelivered(to, id);
    }

    @Override
    public void messageUndelivered(int id, Msisdn to, int status) {
        handset.messages().undelivered(id);
        listener.messageUndelivered(to, id, status);
    }

    @Override
    public void broadcastReceived(int channel, int pages, String text) {
        handset.messages().broadcastReceived(channel, pages, text);
        listener.broadcastReceived(channel, pages, text);
    }

    @Override
    public void stateChanged(StationSnapshot snapshot) {
        handset.changed();
    }
}
