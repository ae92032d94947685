package simgsm.station;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.air.RpCause;
import simgsm.dtmf.DtmfKey;

/** What a station has told, a line each. */
final class Told implements StationListener {
    MobileStation station;
    boolean answersAtOnce;
    final List<short[]> heard = new ArrayList<>();
    private final List<String> lines = new ArrayList<>();

    List<String> lines() {
        return List.copyOf(lines);
    }

    void clear() {
        lines.clear();
    }

    @Override
    public void registered(Msisdn number) {
        lines.add("registered " + number);
    }

    @Override
    public void unregistered(Optional<RejectCause> cause) {
        lines.add("unregistered" + cause.map(c -> " " + c.code()).orElse(""));
    }

    @Override
    public void calling(Msisdn number) {
        lines.add("calling " + number);
    }

    @Override
    public void alerting() {
        lines.add("alerting");
    }

    @Override
    public void ringing(Optional<Msisdn> from) {
        lines.add("ringing " + from.map(Msisdn::digits).orElse("?"));
        if (answersAtOnce) {
            station.answer();
        }
    }

    @Override
    public void connected(Optional<Msisdn> peer) {
        lines.add("connected " + peer.map(Msisdn::digits).orElse("?"));
    }

    @Override
    public void released(Cause cause) {
        lines.add("released " + cause.code());
    }

    @Override
    public void networkTones(boolean heard) {
        lines.add(heard ? "network tones" : "own tones");
    }

    @Override
    public void keySounds(DtmfKey key) {
        lines.add("sounds " + key.symbol());
    }

    @Override
    public void keyLetGo(DtmfKey key) {
        lines.add("let go " + key.symbol());
    }

    @Override
    public void keyLeft(DtmfKey key) {
        lines.add("left " + key.symbol());
    }

    @Override
    public void keysRefused(Cause cause) {
        lines.add("keys refused " + cause.code());
    }

    @Override
    public void speechReceived(short[] samples) {
        heard.add(samples);
    }

    @Override
    public void messageSent(int id, Msisdn to, int parts) {
        lines.add("sent " + id + " to " + to + " in " + parts);
    }

    @Override
    public void messageFailed(int id, Msisdn to, RpCause cause) {
        lines.add("failed " + id + " to " + to + " " + cause.code());
    }

    @Override
    public void messageReceived(String from, String text) {
        lines.add("message from " + from + ": " + text);
    }

    @Override
    public void messageUndelivered(int id, Msisdn to, int status) {
        lines.add("undelivered " + id + " to " + to + ", status " + status);
    }

    @Override
    public void messageDelivered(int id, Msisdn to) {
        lines.add("delivered " + id + " to " + to);
    }

    @Override
    public void broadcastReceived(int channel, int pages, String text) {
        lines.add("broadcast " + channel + " in " + pages + ": " + text);
    }
}
