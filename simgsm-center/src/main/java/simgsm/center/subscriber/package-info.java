/**
 * The registers: subscriptions (HLR, EIR) and known subscribers (VLR). Read {@link simgsm.center.subscriber.HomeRegister},
 * then {@link simgsm.center.subscriber.SubscriberRegister}.
 */
package simgsm.center.subscriber;
