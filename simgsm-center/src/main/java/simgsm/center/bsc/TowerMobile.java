package simgsm.center.bsc;

import java.util.Optional;
import java.util.function.Consumer;
import simgsm.abis.IpaFrame;
import simgsm.abis.RslMessage;
import simgsm.air.LocationArea;
import simgsm.air.MobileIdentity;
import simgsm.center.msc.link.BroadcastChannel;
import simgsm.center.msc.link.Link;
import simgsm.center.msc.link.RadioAccess;
import simgsm.octets.OctetString;

/** A mobile of the towers: reached on its radio connection, or by paging in its location area. */
final class TowerMobile implements RadioAccess {
    private final BaseStationController controller;
    private final Link link;
    private Optional<RadioConnection> connection = Optional.empty();
    private LocationArea area;

    TowerMobile(BaseStationController controller, TowerControl tower) {
        this.controller = controller;
        this.area = tower.plan().area();
        this.link = new Link(this, tower.address(), tower.isLocal(), controller.links());
    }

    Link link() {
        return link;
    }

    /** Begins a radio connection; an older one is lost. */
    void connected(RadioConnection begun) {
        connection.ifPresent(RadioConnection::lost);
        connection = Optional.of(begun);
        area = begun.channel().tower().plan().area();
    }

    @Override
    public void takeOver(RadioAccess other) {
        TowerMobile provisional = (TowerMobile) other;
        RadioConnection proved = provisional.connection.orElseThrow();
        provisional.connection = Optional.empty();
        proved.belongTo(this);
        connected(proved);
    }

    /** Handles the end of the radio connection. */
    void disconnected(RadioConnection ended) {
        if (connection.filter(own -> own == ended).isPresent()) {
            connection = Optional.empty();
            controller.uplink().left(link);
            forgetIfUnknown();
        }
    }

    /** Removes a mobile without a subscriber; its next message creates another. */
    private void forgetIfUnknown() {
        if (!link.hasSubscriber()) {
            link.forget();
        }
    }

    @Override
    public void send(RslMessage.Sapi sapi, OctetString layer3) {
        connection.ifPresent(own -> own.send(sapi.code(), layer3));
    }

    @Override
    public void cipher(OctetString kc, Consumer<Boolean> done) {
        connection.ifPresent(own -> own.cipher().begin(kc, done));
    }

    @Override
    public boolean isCiphered() {
        return connection.filter(own -> own.cipher().isOn()).isPresent();
    }

    @Override
    public void release() {
        connection.ifPresent(RadioConnection::release);
    }

    @Override
    public void page(MobileIdentity identity) {
        controller.page(link, area, identity);
    }

    @Override
    public LocationArea area() {
        return area;
    }

    @Override
    public BroadcastChannel broadcastChannel() {
        return controller;
    }

    @Override
    public void setSpeechNeed(SpeechNeed need) {
        connection.ifPresent(own -> own.setSpeechNeeded(need != SpeechNeed.NONE));
    }

    @Override
    public void sendSpeech(IpaFrame frame) {
        connection.ifPresent(own -> own.sendSpeech(frame.payload()));
    }

    @Override
    public boolean isShared() {
        return true;
    }

    @Override
    public void close(String reason) {
        connection.ifPresent(RadioConnection::lost);
    }
}
