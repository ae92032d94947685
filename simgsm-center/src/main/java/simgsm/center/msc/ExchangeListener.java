package simgsm.center.msc;

/** Hears what happens in the exchange, on the thread that drives it. */
public interface ExchangeListener {
    void happened(ExchangeEvent event);
}
