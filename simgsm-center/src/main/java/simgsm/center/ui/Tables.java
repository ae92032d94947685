package simgsm.center.ui;

import java.util.List;
import java.util.Locale;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.center.msc.BroadcastView;
import simgsm.center.msc.ExchangeSnapshot.MessageRow;
import simgsm.center.msc.ExchangeSnapshot.SubscriberRow;
import simgsm.center.msc.call.CallProgress;
import simgsm.center.msc.call.CallView;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.draw.StatusMark;

/** The four tables and their columns. */
final class Tables {
    private Tables() {}

    static RowsPanel<SubscriberRow> subscribers(TextBundle texts) {
        StateWord attached = new StateWord(StatusMark.DISC, Ink.GOOD, texts.of("window.subscriber.attached"));
        StateWord barred = new StateWord(StatusMark.SLASHED_RING, Ink.DANGER, texts.of("window.subscriber.barred"));
        StateWord detached = new StateWord(StatusMark.RING, Ink.QUIET, texts.of("window.subscriber.detached"));
        return new RowsPanel<>(
                "subscribers",
                texts.of("window.subscribers"),
                texts.of("window.subscribers.empty"),
                List.of(
                        new Column<>(texts.of("window.number"), 72, SubscriberRow::number),
                        new Column<>(
                                texts.of("window.state"),
                                104,
                                row -> row.attached() ? attached : row.barred() ? barred : detached),
                        new Column<>("IMSI", 118, row -> new Digits(row.imsi())),
                        new Column<>("IMEI", 118, row -> new Digits(row.imei()))));
    }

    static RowsPanel<CallView> calls(TextBundle texts) {
        return new RowsPanel<>(
                "calls",
                texts.of("window.calls"),
                texts.of("window.calls.empty"),
                List.of(
                        new Column<>(texts.of("window.from"), 72, CallView::from),
                        new Column<>(texts.of("window.to"), 72, call -> number(call.to())),
                        new Column<>(texts.of("window.state"), 96, call -> word(call.state(), texts)),
                        new Column<>(texts.of("window.duration"), 60, Tables::duration),
                        new Column<>(
                                texts.of("window.cause"),
                                110,
                                call -> call.cause()
                                        .map(cause -> cause.code() + " " + title(cause, texts))
                                        .orElse(""))));
    }

    /** Names a cause; normal call clearing in plain words. */
    private static String title(Cause cause, TextBundle texts) {
        return cause == Cause.NORMAL_CALL_CLEARING ? texts.of("window.cause.normal") : cause.title(texts.language());
    }

    /** Minutes and seconds, as on a phone's display; empty if the call has not been active. */
    private static Object duration(CallView call) {
        long seconds = call.activeSeconds();
        boolean wasActive = call.state() == CallProgress.ACTIVE || seconds > 0;
        return wasActive ? new Digits(String.format(Locale.ROOT, "%02d:%02d", seconds / 60, seconds % 60)) : "";
    }

    static RowsPanel<MessageRow> messages(TextBundle texts) {
        return new RowsPanel<MessageRow>(
                        "messages",
                        texts.of("window.messages"),
                        texts.of("window.messages.empty"),
                        List.of(
                                new Column<>(
                                        texts.of("window.from"),
                                        66,
                                        row -> row.history().message().sender()),
                                new Column<>(
                                        texts.of("window.to"),
                                        66,
                                        row -> row.history().message().to()),
                                new Column<>(texts.of("window.state"), 116, row -> HistoryWords.state(row, texts)),
                                new Column<>(
                                        texts.of("window.tries"),
                                        40,
                                        row -> new Digits(
                                                String.valueOf(row.history().attemptCount()))),
                                new Column<>(texts.of("window.next"), 60, row -> new Digits(HistoryWords.next(row))),
                                new Column<>(texts.of("window.text"), 92, MessageRow::text)))
                .identifiedBy(row -> row.history().message().id());
    }

    static RowsPanel<BroadcastView> broadcasts(TextBundle texts) {
        return new RowsPanel<BroadcastView>(
                        "broadcasts",
                        texts.of("window.broadcasts"),
                        texts.of("window.broadcasts.empty"),
                        List.of(
                                new Column<>(
                                        texts.of("window.broadcast.channel"),
                                        56,
                                        row -> new Digits(String.valueOf(row.channel()))),
                                new Column<>(
                                        texts.of("window.broadcast.sent.times"), 56, row -> new Digits(sentOf(row))),
                                new Column<>(
                                        texts.of("window.broadcast.every"),
                                        56,
                                        row -> new Digits(row.period().toSeconds() + " s")),
                                new Column<>(texts.of("window.text"), 220, BroadcastView::text)))
                .identifiedBy(BroadcastView::id);
    }

    private static String sentOf(BroadcastView row) {
        return row.sent()
                + (row.left().isPresent() ? "/" + (row.sent() + row.left().getAsInt()) : "");
    }

    /** The dialled number; empty for an empty one. */
    private static Object number(String dialled) {
        return dialled.isEmpty() ? "" : new Msisdn(dialled);
    }

    static StateWord word(CallProgress state, TextBundle texts) {
        String word = texts.of("window.call." + state.name().toLowerCase(Locale.ROOT));
        switch (state) {
            case INITIATED:
                return new StateWord(StatusMark.HALF_DISC, Ink.WARNING, word);
            case ALERTING:
                return new StateWord(StatusMark.DIAMOND, Ink.WARNING, word);
            case ACTIVE:
                return new StateWord(StatusMark.ARROW, Ink.GOOD, word);
            default:
                return new StateWord(StatusMark.RING, Ink.QUIET, word);
        }
    }
}
